// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/mesh/normals.h>

namespace vug::mesh {

double corner_angle(const std::array<Vec3d, 3>& triangle, int k) {
  const Vec3d u = triangle[static_cast<size_t>((k + 1) % 3)] - triangle[static_cast<size_t>(k)];
  const Vec3d v = triangle[static_cast<size_t>((k + 2) % 3)] - triangle[static_cast<size_t>(k)];
  return maths::atan2(u.cross(v).length(), u.dot(v));
}

std::vector<Vec3d> vertex_pseudonormals(const Mesh& mesh) {
  std::vector<Vec3d> weighted(3 * mesh.triangles.size());
  parallel_for(
      mesh.triangles.size(),
      [&](size_t face) {
        const std::array<Vec3d, 3> triangle = corners(mesh, face);
        const Vec3d normal = double_area_vector(mesh, face).normalized();
        for (int k = 0; k < 3; ++k)
          weighted[3 * face + static_cast<size_t>(k)] = normal * corner_angle(triangle, k);
      },
      1024);
  std::vector<Vec3d> sum(mesh.positions.size(), Vec3d(0));
  for (size_t h = 0; h < weighted.size(); ++h) sum[mesh.triangles[h / 3][h % 3]] += weighted[h];
  return sum;
}

Vec3d vertex_pseudonormal(const Mesh& mesh, const Fans& fans, uint32_t vertex) {
  Vec3d sum(0);
  for (const uint32_t face : fans.at(vertex)) {
    const Triangle& t = mesh.triangles[face];
    const int k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    sum += double_area_vector(mesh, face).normalized() * corner_angle(corners(mesh, face), k);
  }
  return sum;
}

std::vector<Vec3f> vertex_normals(const Mesh& mesh) {
  const std::vector<Vec3d> sums = vertex_pseudonormals(mesh);
  std::vector<Vec3f> normals(sums.size());
  for (size_t i = 0; i < sums.size(); ++i) {
    const Vec3d unit = sums[i].normalized();
    normals[i] = unit == Vec3d(0) ? Vec3f(0, 1, 0) : Vec3f(unit);
  }
  return normals;
}

}  // namespace vug::mesh
