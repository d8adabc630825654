// SPDX-License-Identifier: Apache-2.0
// Ray intersection with the surface of a level set, without a mesh, and its normals.
#pragma once

#include <vug/volume/surface_bricks.h>

#include <array>
#include <optional>

namespace vug::render {

struct Crossing {
  double t = 0;
  std::array<int, 3> cell{0, 0, 0};  ///< Index of its first lattice point.
  bool outwards = false;             ///< The ray leaves the solid.
};

/// The first crossing of a ray, begin <= t <= end, with the zero of the trilinear interpolant in a
/// brick; the direction may have any length. Within a cell the interpolant along a ray is a cubic
/// (Parker et al. 1998, "Interactive ray tracing for isosurface rendering", cite
/// parker1998isosurface), whose first root is bracketed between its extrema (Marmitt et al. 2004,
/// "Fast and accurate ray-voxel intersection techniques for iso-surface ray tracing", cite
/// marmitt2004isosurface). At the face between two cells both use the same sign, even if they are
/// in different bricks, so that no ray passes between them.
std::optional<Crossing> first_crossing(const volume::SurfaceBricks& surface, size_t brick,
                                       const Vec3d& origin, const Vec3d& direction, double begin,
                                       double end);

/// A value in metres, negative inside, and its gradient.
struct GridValue {
  double value = 0;
  Vec3d gradient{0, 0, 0};
};

/// The trilinear interpolant in a cell that the surface crosses.
GridValue trilinear(const volume::SurfaceBricks& surface, size_t brick,
                    const std::array<int, 3>& cell, const Vec3d& point);
/// Trilinear value with the cell looked up; for points up to one voxel outside the brick.
double trilinear_value(const volume::SurfaceBricks& surface, size_t brick, const Vec3d& point);
/// A smooth interpolant without facets: the value by Catmull-Rom cubics (cite catmull1974) within a
/// brick; the gradient by interpolating central differences, in the way in which
/// Hansson-Soederlund, Evans and Akenine-Moeller 2022, "Ray tracing of signed distance function
/// grids" (cite hansson2022grids), interpolate the gradients of overlapping cells.
GridValue smooth(const volume::SurfaceBricks& surface, size_t brick, const std::array<int, 3>& cell,
                 const Vec3d& point);

}  // namespace vug::render
