// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/components.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>

#include <algorithm>
#include <utility>

namespace vug::mesh {

std::vector<Box3d> component_bounds(const Mesh& mesh, const std::vector<uint32_t>& component_of) {
  std::vector<Box3d> boxes;
  for (size_t face = 0; face < component_of.size(); ++face) {
    if (component_of[face] == boxes.size()) boxes.emplace_back();
    for (const Vec3d& corner : corners(mesh, face)) boxes[component_of[face]].extendBy(corner);
  }
  return boxes;
}

std::vector<double> component_volumes(const Mesh& mesh, const std::vector<uint32_t>& component_of) {
  std::vector<double> volumes;
  std::vector<Vec3d> origins;  // A point of each, because a distant origin loses digits.
  for (size_t face = 0; face < component_of.size(); ++face) {
    const auto [a, b, c] = corners(mesh, face);
    if (component_of[face] == volumes.size()) {
      volumes.push_back(0);
      origins.push_back(a);
    }
    const Vec3d& o = origins[component_of[face]];
    volumes[component_of[face]] += (a - o).dot((b - o).cross(c - o)) / 6;  // Of a tetrahedron.
  }
  return volumes;
}

Mesh remaining(Mesh mesh, const std::vector<uint32_t>& component_of,
               const std::vector<char>& remains) {
  std::vector<Triangle> kept;
  for (size_t face = 0; face < component_of.size(); ++face)
    if (remains[component_of[face]]) kept.push_back(mesh.triangles[face]);
  mesh.triangles = std::move(kept);
  return without_unused_vertices(mesh);
}

LargeComponents large_components(Mesh mesh, double smallest) {
  if (smallest <= 0 || mesh.triangles.empty()) return {std::move(mesh), 0};
  const std::vector<uint32_t> piece_of = face_components(mesh, find_edges(mesh));
  std::vector<double> squares;  // Of the diagonals.
  for (const Box3d& box : component_bounds(mesh, piece_of))
    squares.push_back(box.size().dot(box.size()));
  const double enough =
      std::min(smallest * smallest, *std::max_element(squares.begin(), squares.end()));
  std::vector<char> remains;
  for (const double square : squares) remains.push_back(square >= enough);
  const auto small = static_cast<size_t>(std::count(remains.begin(), remains.end(), 0));
  if (small == 0) return {std::move(mesh), 0};
  return {remaining(std::move(mesh), piece_of, remains), small};
}

}  // namespace vug::mesh
