// From a surface to a network: strewn, harmonised, linked, oriented.
#pragma once

#include <vug/cells/grid.h>
#include <vug/cells/network.h>
#include <vug/cells/relax.h>

#include <optional>

namespace vug::cells {

struct BuildOptions {
  Grid grid;
  double spacing = 0.02;  ///< Metres from cell to cell, about; above 0.
  RandomKey key{0};
  Force force = Force::squared;
  std::optional<int> relax;  ///< Steps of harmonising; the grid's own number when not given.
  uint64_t memory = 0;       ///< Bytes it may take at most; 0: what the machine has left.
};

struct BuildResult {
  Network network;
  std::vector<RelaxStep> relaxing;
};

/// The same bytes for any number of threads and any order of polygons.
/// Error(bad_input) where the spacing is larger than an object; Error(too_large) where cells would
/// be too many to number or to hold in memory.
BuildResult build(const Surface& surface, const BuildOptions& options,
                  Progress& progress = Progress::none());

/// Cells that a surface of so many square metres will have, about.
double estimate(double area, const Grid& grid, double spacing);
inline double estimate(const Surface& surface, const Grid& grid, double spacing) {
  return estimate(surface.area(), grid, spacing);
}

/// What build refuses for its size: Error(too_large) where so many cells cannot be numbered, or
/// not be strewn and linked within the options' memory.
void require_memory(double cells, const BuildOptions& options);

}  // namespace vug::cells
