// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/components.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>

#include <algorithm>
#include <utility>

namespace vug::mesh {
namespace {

/// Squared diagonals of the components' bounding boxes.
std::vector<double> sizes(const Mesh& mesh, const std::vector<uint32_t>& piece_of) {
  std::vector<Box3d> boxes;
  for (size_t face = 0; face < piece_of.size(); ++face) {
    if (piece_of[face] == boxes.size()) boxes.emplace_back();
    for (const Vec3d& corner : corners(mesh, face)) boxes[piece_of[face]].extendBy(corner);
  }
  std::vector<double> squares;
  for (const Box3d& box : boxes) squares.push_back(box.size().dot(box.size()));
  return squares;
}

}  // namespace

LargeComponents large_components(Mesh mesh, double smallest) {
  if (smallest <= 0 || mesh.triangles.empty()) return {std::move(mesh), 0};
  const std::vector<uint32_t> piece_of = face_components(mesh, find_edges(mesh));
  const std::vector<double> squares = sizes(mesh, piece_of);
  const double enough =
      std::min(smallest * smallest, *std::max_element(squares.begin(), squares.end()));
  const auto small =
      std::count_if(squares.begin(), squares.end(), [&](double square) { return square < enough; });
  if (small == 0) return {std::move(mesh), 0};
  std::vector<Triangle> kept;
  for (size_t face = 0; face < piece_of.size(); ++face)
    if (squares[piece_of[face]] >= enough) kept.push_back(mesh.triangles[face]);
  mesh.triangles = std::move(kept);
  return {without_unused_vertices(mesh), static_cast<size_t>(small)};
}

}  // namespace vug::mesh
