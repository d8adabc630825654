// SPDX-License-Identifier: Apache-2.0
// Construction of a network from a surface: scattering, relaxation, linking and orientation of
// cells.
#pragma once

#include <vug/cells/grid.h>
#include <vug/cells/network.h>
#include <vug/cells/relax.h>

#include <optional>

namespace vug::cells {

struct BuildOptions {
  Grid grid;
  double spacing = 0.02;  ///< Approximate distance between cells in metres; above 0.
  RandomKey key{0};
  Force force = Force::squared;
  std::optional<int> relax;  ///< Relaxation steps; default: the number of the grid.
  uint64_t memory = 0;       ///< Memory limit in bytes; 0: the available memory of the machine.
};

struct BuildResult {
  Network network;
  std::vector<RelaxStep> relaxation;
};

/// The result has the same bytes for any number of threads and any order of polygons. Throws
/// Error(bad_input) if the spacing is larger than an object; Error(too_large) if there are too many
/// cells for the index type or the memory.
BuildResult build(const Surface& surface, const BuildOptions& options,
                  Progress& progress = Progress::none());

/// Approximate number of cells for a surface of this area in square metres.
double estimate(double area, const Grid& grid, double spacing);
inline double estimate(const Surface& surface, const Grid& grid, double spacing) {
  return estimate(surface.area(), grid, spacing);
}

/// Throws Error(too_large) if this number of cells exceeds the index type, or cannot be
/// scattered and linked within the memory limit.
void require_feasible(double cells, const BuildOptions& options);

}  // namespace vug::cells
