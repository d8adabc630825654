// The points of a grid's pattern that fall on one triangle.
#pragma once

#include <vug/cells/grid.h>
#include <vug/cells/surface.h>

#include <vug/base/rng.h>

namespace vug::cells {

/// For each triangle the normal of the plane in which its pattern lies. Where at least 16 squared
/// spacings face the same way (to 1/500) it is that way: a polygon gets the same cells however it
/// is cut into triangles. Curved surfaces have no such facets; there it is one of some two hundred
/// ways, at most 12 degrees off, so that patches are as large as a turn of 14 degrees makes them
/// and the pattern is stretched by 2 percent at most.
std::vector<Vec3d> pattern_planes(const Surface& surface, double spacing);

/// Appends the places of the pattern on a triangle. Rows are level; triangles of one plane normal
/// share one pattern, each point of which falls on one of them. Where it lies in its plane is by
/// chance, from `key` and the normal.
void add_lattice(const Surface& surface, uint32_t triangle, const Grid& grid, double spacing,
                 const Vec3d& plane, RandomKey key, std::vector<SurfacePoint>& out);

}  // namespace vug::cells
