// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/faces.h>

namespace vug::meshing {
namespace {

template <size_t N>
void add(FaceMesh& mesh, const std::array<uint32_t, N>& polygon) {
  Face face;
  face.size = 0;
  for (size_t k = 0; k < N; ++k)
    if (polygon[k] != polygon[(k + 1) % N]) face.corners[face.size++] = polygon[k];
  if (face.size >= 3) mesh.faces.push_back(face);
}

}  // namespace

Vec3d FaceMesh::centre(const Face& face) const {
  Vec3d sum(0);
  for (uint32_t k = 0; k < face.size; ++k) sum += points[face.corners[k]];
  return sum / face.size;
}

FaceMesh face_mesh(const volume::Polygons& polygons) {
  FaceMesh mesh;
  mesh.points.reserve(polygons.points.size());
  for (const Vec3f& p : polygons.points) mesh.points.emplace_back(p);
  mesh.faces.reserve(polygons.quads.size() + polygons.triangles.size());
  for (const auto& quad : polygons.quads) add(mesh, quad);
  for (const auto& triangle : polygons.triangles) add(mesh, triangle);
  mesh.first.assign(mesh.points.size() + 1, 0);
  for (const Face& face : mesh.faces)
    for (uint32_t k = 0; k < face.size; ++k) ++mesh.first[face.corners[k] + 1];
  for (size_t v = 0; v < mesh.points.size(); ++v) mesh.first[v + 1] += mesh.first[v];
  mesh.around.resize(mesh.first.back());
  std::vector<uint32_t> next(mesh.first.begin(), mesh.first.end() - 1);
  for (uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (uint32_t k = 0; k < mesh.faces[f].size; ++k)
      mesh.around[next[mesh.faces[f].corners[k]]++] = f;
  return mesh;
}

Vec3d corner_normal(const Face& face, uint32_t k, const std::vector<Vec3d>& points) {
  const Vec3d& at = points[face.corners[k]];
  const Vec3d& next = points[face.corners[(k + 1) % face.size]];
  const Vec3d& last = points[face.corners[(k + face.size - 1) % face.size]];
  return (next - at).cross(last - at);
}

}  // namespace vug::meshing
