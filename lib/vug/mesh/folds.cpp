// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/folds.h>
#include <vug/mesh/normals.h>

#include <algorithm>

namespace vug::mesh {
namespace {

/// The normals at the corners are given by a function of the vertex, of any length.
template <class Normal>
bool opposes(const Mesh& mesh, uint32_t face, const Normal& normal_at) {
  constexpr double kCosine = -0.5;
  const Vec3d normal = double_area_vector(mesh, face).normalized();
  const Triangle& t = mesh.triangles[face];
  return std::all_of(t.begin(), t.end(),
                     [&](uint32_t v) { return normal.dot(normal_at(v).normalized()) < kCosine; });
}

}  // namespace

std::vector<uint32_t> folded_triangles(const Mesh& mesh) {
  const std::vector<Vec3d> normals = vertex_pseudonormals(mesh);
  std::vector<char> folded(mesh.triangles.size());
  parallel_for(
      folded.size(),
      [&](size_t face) {
        folded[face] =
            opposes(mesh, static_cast<uint32_t>(face), [&](uint32_t v) { return normals[v]; });
      },
      1024);
  std::vector<uint32_t> list;
  for (uint32_t face = 0; face < folded.size(); ++face)
    if (folded[face]) list.push_back(face);
  return list;
}

bool is_folded(const Mesh& mesh, const Fans& fans, uint32_t face) {
  return opposes(mesh, face, [&](uint32_t v) { return vertex_pseudonormal(mesh, fans, v); });
}

}  // namespace vug::mesh
