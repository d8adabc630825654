// Where rays meet the surface of a level set, and what it is like there: no mesh.
#pragma once

#include <vug/volume/surface_bricks.h>

#include <array>
#include <optional>

namespace vug::render {

struct Crossing {
  double t = 0;
  std::array<int, 3> cell{0, 0, 0};  ///< By its first lattice point.
  bool outwards = false;             ///< The ray leaves the solid.
};

/// Where a ray, begin <= t <= end, first crosses the zero of the trilinear interpolant in a brick;
/// the direction may have any length. Within a cell the interpolant along a ray is a cubic (Parker
/// et al. 1998, "Interactive ray tracing for isosurface rendering", cite parker1998isosurface),
/// whose first root is bracketed between its extrema (Marmitt et al. 2004, "Fast and accurate
/// ray-voxel intersection techniques for iso-surface ray tracing", cite marmitt2004isosurface).
/// Signs where the ray goes from one cell to the next are those that the next cell sees, in this
/// brick or another: no ray slips through between.
std::optional<Crossing> first_crossing(const volume::SurfaceBricks& surface, size_t brick,
                                       const Vec3d& origin, const Vec3d& direction, double begin,
                                       double end);

/// A value in metres, below 0 inside, and its slope.
struct GridValue {
  double value = 0;
  Vec3d gradient{0, 0, 0};
};

/// The interpolant in a cell that the surface crosses.
GridValue trilinear(const volume::SurfaceBricks& surface, size_t brick,
                    const std::array<int, 3>& cell, const Vec3d& point);
/// The same, its cell found; for places up to a voxel away from the brick.
double trilinear_value(const volume::SurfaceBricks& surface, size_t brick, const Vec3d& point);
/// Smooth from cell to cell: the value by Catmull and Rom's cubics (cite catmull1974), within a
/// brick; the slope between central differences, as it is in Hansson-Soederlund, Evans and
/// Akenine-Moeller 2022, "Ray tracing of signed distance function grids" (cite hansson2022grids),
/// between those of overlapping cells: normals without facets.
GridValue smooth(const volume::SurfaceBricks& surface, size_t brick, const std::array<int, 3>& cell,
                 const Vec3d& point);

}  // namespace vug::render
