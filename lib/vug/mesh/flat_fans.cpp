// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/mesh/fans.h>
#include <vug/mesh/flat_fans.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

/// Two unit vectors that are perpendicular to the normal and to each other.
std::array<Vec3d, 2> tangents(const Vec3d& normal) {
  const Vec3d other = std::fabs(normal.x) < 0.7 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d first = normal.cross(other).normalized();
  return {first, normal.cross(first)};
}

bool is_flat(const Mesh& mesh, uint32_t v, std::span<const uint32_t> faces) {
  constexpr double kLeastCosine = 0.05;  // Leaves room for rounding.
  constexpr size_t kMostFaces = 32;
  const size_t count = faces.size();
  if (count < 3 || count > kMostFaces) return false;
  Vec3d normals[kMostFaces];
  Vec3d normal(0);
  for (size_t i = 0; i < count; ++i) normal += normals[i] = double_area_vector(mesh, faces[i]);
  normal = normal.normalized();
  const auto [right, up] = tangents(normal);
  const Vec3d centre(mesh.positions[v]);
  uint32_t starts[kMostFaces], ends[kMostFaces];  // Of the edges opposite to the vertex.
  double turn = 0;
  for (size_t i = 0; i < count; ++i) {
    if (!(normals[i].dot(normal) > kLeastCosine * normals[i].length())) return false;
    const Triangle& t = mesh.triangles[faces[i]];
    const size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    starts[i] = t[(k + 1) % 3], ends[i] = t[(k + 2) % 3];
    const Vec3d a = Vec3d(mesh.positions[starts[i]]) - centre;
    const Vec3d b = Vec3d(mesh.positions[ends[i]]) - centre;
    const double ax = a.dot(right), ay = a.dot(up), bx = b.dot(right), by = b.dot(up);
    turn += maths::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  std::sort(starts, starts + count), std::sort(ends, ends + count);
  return std::equal(starts, starts + count, ends) && std::fabs(turn - 2 * kPi) < 0.1;
}

}  // namespace

std::vector<char> flat_fans(const Mesh& mesh) {
  const Fans fans(mesh);
  std::vector<char> flat(mesh.positions.size());
  parallel_for(
      flat.size(),
      [&](size_t v) {
        flat[v] = is_flat(mesh, static_cast<uint32_t>(v), fans.at(static_cast<uint32_t>(v)));
      },
      1024);
  return flat;
}

}  // namespace vug::mesh
