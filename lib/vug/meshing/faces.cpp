// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cell.h>
#include <vug/base/parallel.h>
#include <vug/base/parallel_sort.h>
#include <vug/meshing/faces.h>

#include <algorithm>
#include <compare>

namespace vug::meshing {
namespace {

/// A point in canonical order. The positions order the points of one cell.
struct OrderedPoint {
  Cell cell{};
  std::array<float, 3> position{};
  uint32_t index = 0;
  auto operator<=>(const OrderedPoint&) const = default;
};

std::vector<OrderedPoint> ordered(const std::vector<Vec3f>& points, double voxel) {
  std::vector<OrderedPoint> out(points.size());
  parallel_for(
      points.size(),
      [&](size_t i) {
        const Vec3f& p = points[i];
        out[i] = {cell_at(Vec3d(p), voxel), {p.x, p.y, p.z}, static_cast<uint32_t>(i)};
      },
      4096);
  parallel_sort(out.begin(), out.end());
  return out;
}

/// `renamed`: the new index of each point.
template <size_t N>
void add(FaceMesh& mesh, const std::array<uint32_t, N>& polygon,
         const std::vector<uint32_t>& renamed) {
  Face face;
  face.size = 0;
  for (size_t k = 0; k < N; ++k)
    if (polygon[k] != polygon[(k + 1) % N]) face.corners[face.size++] = renamed[polygon[k]];
  if (face.size < 3) return;
  const auto end = face.corners.begin() + face.size;
  std::rotate(face.corners.begin(), std::min_element(face.corners.begin(), end), end);
  mesh.faces.push_back(face);
}

}  // namespace

Vec3d FaceMesh::centre(const Face& face) const {
  Vec3d sum(0);
  for (uint32_t k = 0; k < face.size; ++k) sum += points[face.corners[k]];
  return sum / face.size;
}

FaceMesh face_mesh(const volume::Polygons& polygons, double voxel) {
  FaceMesh mesh;
  mesh.points.reserve(polygons.points.size());
  std::vector<uint32_t> renamed(polygons.points.size());
  for (const OrderedPoint& point : ordered(polygons.points, voxel)) {
    renamed[point.index] = static_cast<uint32_t>(mesh.points.size());
    mesh.points.emplace_back(polygons.points[point.index]);
  }
  mesh.faces.reserve(polygons.quads.size() + polygons.triangles.size());
  for (const auto& quad : polygons.quads) add(mesh, quad, renamed);
  for (const auto& triangle : polygons.triangles) add(mesh, triangle, renamed);
  parallel_sort(mesh.faces.begin(), mesh.faces.end());
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
