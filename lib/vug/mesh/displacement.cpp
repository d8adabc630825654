// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/displacement.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {

double max_displacement(const Mesh& before, const Mesh& after) {
  const double squared = ordered_reduce(
      before.positions.size(), 0.0,
      [&](size_t v) { return (Vec3d(after.positions[v]) - Vec3d(before.positions[v])).length2(); },
      [](double a, double b) { return std::max(a, b); });
  return std::sqrt(squared);
}

size_t flipped_triangles(const Mesh& before, const Mesh& after) {
  return ordered_sum(before.triangles.size(), size_t{0}, [&](size_t face) {
    const bool turned = double_area_vector(before, face).dot(double_area_vector(after, face)) < 0;
    return static_cast<size_t>(turned);
  });
}

}  // namespace vug::mesh
