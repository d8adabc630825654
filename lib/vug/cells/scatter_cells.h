// Where cells are laid: a grid's pattern on each facet of a surface, made one along the seams.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/rng.h>
#include <vug/cells/grid.h>
#include <vug/cells/surface.h>

namespace vug::cells {

/// Lays the pattern on every triangle (cells/lattice.h); of cells that come too close to another
/// where facets meet one goes (`thin` of the grid), and darts fill the gaps that are left (`gap`).
/// A random grid is all darts, a Poisson-disk set [@cook1986stochastic]. What is close is judged by
/// surface_distance2, so the sides of a thin wall do not know of each other. Randomness comes from
/// `key` and from where a triangle lies: other polygons and their order do not matter.
std::vector<SurfacePoint> scatter_cells(const Surface& surface, const Grid& grid, double spacing,
                                        RandomKey key, Progress& progress = Progress::none());

}  // namespace vug::cells
