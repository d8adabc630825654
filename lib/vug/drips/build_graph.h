// SPDX-License-Identifier: Apache-2.0
// The graph of the water that drips into a cave, from the rock and its joints.
#pragma once

#include <vug/drips/edits.h>
#include <vug/drips/film_path.h>
#include <vug/drips/graph.h>
#include <vug/drips/seeps.h>

namespace vug::drips {

struct GraphOptions : SeepOptions {
  double temperature = 10;  ///< Degrees Celsius of the cave, 0 to 30.
  double mixing = 0.5;      ///< See seep_calcium.
  double girth = 0.05;      ///< Radius in metres of a stalactite that is a metre long.
  double straws = 0.2;      ///< The share of the drips at which straws hang.
  DripEdits edits{};        ///< Changes of the seeps that are found.
  FilmOptions film{};       ///< Its temperature and region are replaced.
  /// Whether films are followed down walls, over floors and through pools; without, the graph ends
  /// where drops land and where roofs become walls.
  bool run_out = true;
  /// Whether films are also followed over floors and through pools. Speleothems do not depend on
  /// these, except flowstone, and skirts at landings that such a film reaches.
  bool over_floors = true;
  uint64_t memory = uint64_t(8) << 30;  ///< Bytes that the graph may use.

  /// Adds all but the limit of the memory, which does not change a graph.
  void add_to(Digester& digester) const {
    digester(static_cast<const SeepOptions&>(*this), temperature, mixing, girth, straws, edits,
             film, run_out, over_floors);
  }
};

/// The memory in bytes that the graph needs at most.
double graph_memory(const SeepOptions& options);

/// Finds seeps, films, drops, landings and pools. Air is where the rock is positive. The result is
/// the same for any number of threads. Throws Error(bad_input) as find_seeps and edited, and
/// Error(too_large) if the graph needs more memory than allowed.
Graph build_graph(const field::Field& rock, const GraphOptions& options);

/// The ways of only the water that the edits of `options` add or move, as far as it drips or
/// reaches a floor. The drips of the roof are searched only if edits refer to them. Throws as
/// build_graph.
Graph ways_of_edits(const field::Field& rock, const GraphOptions& options);

}  // namespace vug::drips
