// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/retreat.h>
#include <vug/meshing/remove_crossings.h>
#include <vug/meshing/split_quads.h>

#include <algorithm>

namespace vug::meshing {
namespace {

/// Splits a quad along the shorter diagonal if all its vertices are at their raw positions.
bool split_raw(const FaceMesh& raw, uint32_t f, uint32_t first_triangle, mesh::Mesh& mesh) {
  const Face& face = raw.faces[f];
  const auto is_raw = [&](uint32_t v) { return mesh.positions[v] == Vec3f(raw.points[v]); };
  if (face.size != 4 || !std::all_of(face.corners.begin(), face.corners.end(), is_raw))
    return false;
  const auto [a, b] = halves(face, shorter_from_0(face, raw.points));
  const bool differs = mesh.triangles[first_triangle] != a;
  mesh.triangles[first_triangle] = a;
  mesh.triangles[first_triangle + 1] = b;
  return differs;
}

}  // namespace

void remove_crossings(const FaceMesh& raw, MoveResult& moved, mesh::Mesh& mesh) {
  mesh::PolygonGroups polygons;
  uint32_t triangle = 0;
  for (const Face& face : raw.faces) {
    polygons.first.push_back(triangle);
    triangle += face.size - 2;
  }
  polygons.first.push_back(triangle);
  polygons.divide = [&](uint32_t f) { return split_raw(raw, f, polygons.first[f], mesh); };
  const std::vector<Vec3f> before(raw.points.begin(), raw.points.end());
  const std::vector<float> shares = mesh::retreat(before, mesh, polygons);
  for (uint32_t v = 0; v < shares.size(); ++v) {
    if (shares[v] == 1) continue;
    moved.points[v] = Vec3d(mesh.positions[v]);
    moved.on_crease[v] = 0;
    ++moved.shortened_moves;
  }
}

}  // namespace vug::meshing
