// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/mesh/winding_number.h>

namespace vug::mesh {

double winding_number(const Mesh& mesh, const Vec3d& p) {
  // Half of each solid angle (vanoosterom1983).
  const double sum = ordered_sum(mesh.triangles.size(), 0.0, [&](size_t face) {
    const auto [a, b, c] = corners(mesh, face);
    const Vec3d u = a - p, v = b - p, w = c - p;
    const double x = u.length(), y = v.length(), z = w.length();
    return maths::atan2(u.dot(v.cross(w)), x * y * z + u.dot(v) * z + v.dot(w) * x + w.dot(u) * y);
  });
  return sum / (2 * kPi);
}

}  // namespace vug::mesh
