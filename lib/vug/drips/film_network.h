// SPDX-License-Identifier: Apache-2.0
// Films that run side by side become nodes and edges of a graph.
#pragma once

#include <vug/drips/film_path.h>
#include <vug/drips/graph.h>

namespace vug::drips {

/// One film for each of the nodes from which water runs, in the order of their ids.
struct FilmNetwork {
  EdgeKind kind = EdgeKind::ceiling_film;
  std::vector<int> sources{};  ///< Indices of nodes of the graph.
  std::vector<Film> films{};
  double merging = 0.024;  ///< Metres: films that come nearer than this to a lower point of another
                           ///< one run into it.
};

/// The width in metres of the films of a kind.
double film_width(EdgeKind kind);

/// Adds the films to the graph: a node for each film's end, of kind `sink` with the source's id,
/// and confluences. Water loses calcium on its way. Returns the nodes of the ends, -1 for films
/// that run into another.
std::vector<int> add_films(Graph& graph, FilmNetwork network);

/// The water that arrives at the end of a film of this width in metres.
Water after_film(Water water, const std::vector<Vec3d>& path, double width);

/// The water of two inflows together.
Water mixed(const Water& a, const Water& b);

}  // namespace vug::drips
