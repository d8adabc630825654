// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/polygon.h>

namespace vug::mesh {
namespace {

constexpr size_t kMaxEars = 64;

/// Newell's normal: the sum of the fan's area vectors, also for concave polygons.
Vec3d polygon_normal(const Mesh& mesh, const std::vector<uint32_t>& polygon) {
  Vec3d sum(0);
  const Vec3d origin(mesh.positions[polygon[0]]);
  for (size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (Vec3d(mesh.positions[polygon[i]]) - origin)
               .cross(Vec3d(mesh.positions[polygon[i + 1]]) - origin);
  return sum;
}

/// Whether corner b of the polygon can be cut off: it is convex and contains no other corner.
bool is_ear(const Mesh& mesh, const std::vector<uint32_t>& polygon, size_t at,
            const Vec3d& normal) {
  const size_t n = polygon.size();
  const std::array<uint32_t, 3> corner = {polygon[(at + n - 1) % n], polygon[at],
                                          polygon[(at + 1) % n]};
  std::array<Vec3d, 3> p;
  for (size_t k = 0; k < 3; ++k) p[k] = Vec3d(mesh.positions[corner[k]]);
  if ((p[1] - p[0]).cross(p[2] - p[1]).dot(normal) <= 0) return false;
  for (const uint32_t other : polygon) {
    if (other == corner[0] || other == corner[1] || other == corner[2]) continue;
    const Vec3d q(mesh.positions[other]);
    bool inside = true;
    for (size_t k = 0; k < 3 && inside; ++k)
      inside = (p[(k + 1) % 3] - p[k]).cross(q - p[k]).dot(normal) >= 0;
    if (inside) return false;
  }
  return true;
}

}  // namespace

void add_polygon(Mesh& mesh, const std::vector<uint32_t>& polygon) {
  if (polygon.size() > kMaxEars) {
    try {
      return add_rings(mesh, {polygon});
    } catch (const Error&) {  // The polygon intersects itself.
    }
  }
  std::vector<uint32_t> rest = polygon;
  const Vec3d normal = polygon_normal(mesh, polygon);
  while (rest.size() > 3 && polygon.size() <= kMaxEars) {
    const size_t n = rest.size();
    size_t ear = 1;
    while (ear <= n && !is_ear(mesh, rest, ear % n, normal)) ++ear;
    if (ear > n) break;
    ear %= n;
    mesh.triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<int64_t>(ear));
  }
  for (size_t i = 1; i + 1 < rest.size(); ++i)
    mesh.triangles.push_back({rest[0], rest[i], rest[i + 1]});
}

}  // namespace vug::mesh
