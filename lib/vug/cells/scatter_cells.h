// SPDX-License-Identifier: Apache-2.0
// Initial placement of cells: a grid's pattern on each facet of a surface, joined along the seams.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/rng.h>
#include <vug/cells/grid.h>
#include <vug/cells/surface.h>

namespace vug::cells {

/// Places the pattern on every triangle (cells/lattice.h). Of cells that are too close to each
/// other where facets meet, one is removed (`thin` of the grid), and dart throwing fills the
/// remaining gaps (`gap`). A random grid uses dart throwing only, which gives a Poisson-disk set
/// [@cook1986stochastic]. Distances are those of surface_distance2, so the sides of a thin wall are
/// independent. Random numbers derive from `key` and the position of a triangle: other polygons and
/// their order are irrelevant.
std::vector<SurfacePoint> scatter_cells(const Surface& surface, const Grid& grid, double spacing,
                                        RandomKey key, Progress& progress = Progress::none());

}  // namespace vug::cells
