// SPDX-License-Identifier: Apache-2.0
// Solids and lattice loops shared by the tests of this folder.
#pragma once

#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/volume/voxelize.h>

#include <cmath>

namespace vug::volume {

inline field::Field sphere_at(const Vec3d& centre, double radius) {
  return field::transformed(field::make("sphere", {{"radius", radius}}),
                            Transform::translation(centre));
}

inline VoxelizeOptions with_voxel(double voxel) {
  VoxelizeOptions options;
  options.voxel = voxel;
  return options;
}

/// Spheres in a cube of edge 2, some blended, some subtracted: all cases of the tree.
inline field::Field lumpy_solid() {
  using namespace field;
  const Field body = unite(
      {sphere_at({0, 0, 0}, 0.7), sphere_at({0.6, 0.1, 0}, 0.4), sphere_at({-0.4, 0.5, 0.2}, 0.45)},
      {Profile::smooth, 0.2});
  return subtract(morph(body, sphere_at({0.2, 0, 0.3}, 0.8), 0.4),
                  {sphere_at({0.3, 0.6, 0.3}, 0.35)});
}

/// Calls visit(point, value in the grid) for every lattice point in and around the band.
template <class Visit>
void each_lattice_point(const LevelSet& grid, const Visit& visit) {
  const Statistics s = grid.statistics();
  std::vector<Vec3d> points;
  for (int x = s.index_min.x - 2; x <= s.index_max.x + 2; ++x)
    for (int y = s.index_min.y - 2; y <= s.index_max.y + 2; ++y)
      for (int z = s.index_min.z - 2; z <= s.index_max.z + 2; ++z)
        points.push_back(Vec3d(x, y, z) * grid.voxel());
  const std::vector<double> values = grid.values(points);
  for (size_t i = 0; i < points.size(); ++i) visit(points[i], values[i]);
}

/// Distance in metres at which the grid's value changes sign along a segment of length `reach` from
/// `from`.
inline double crossing(const LevelSet& grid, const Vec3d& from, const Vec3d& direction,
                       double reach) {
  double low = 0, high = reach;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (grid.value(from + direction * middle) < 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace vug::volume
