// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/shells.h>
#include <vug/mesh/topology.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::mesh {
namespace {

/// Six times the volume of the tetrahedron of a point and a triangle (divergence theorem).
double six_volumes(const Vec3d& from, const std::array<Vec3d, 3>& triangle) {
  return (triangle[0] - from).dot((triangle[1] - from).cross(triangle[2] - from));
}

/// Moves a triangle's corners to the vertices of the shell, which it extends. `copies` has the
/// numbers of the copied vertices.
void add_triangle(Mesh& shell, const Mesh& mesh, size_t face, std::vector<uint32_t>& copies) {
  Triangle triangle = mesh.triangles[face];
  for (uint32_t& corner : triangle) {
    uint32_t& copy = copies[corner];
    if (copy >= shell.positions.size() || shell.positions[copy] != mesh.positions[corner]) {
      copy = static_cast<uint32_t>(shell.positions.size());
      shell.positions.push_back(mesh.positions[corner]);
    }
    corner = copy;
  }
  shell.triangles.push_back(triangle);
}

}  // namespace

std::vector<Shell> shells(const Mesh& closed) {
  const std::vector<uint32_t> shell_of = face_components(closed, find_edges(closed));
  std::vector<Shell> out;
  std::vector<uint32_t> copies(closed.positions.size(), std::numeric_limits<uint32_t>::max());
  for (size_t face = 0; face < shell_of.size(); ++face) {
    if (shell_of[face] == out.size()) out.emplace_back();
    Shell& shell = out[shell_of[face]];
    add_triangle(shell.surface, closed, face, copies);
    // From a point nearby, because a distant one loses digits.
    shell.volume += six_volumes(Vec3d(shell.surface.positions[0]), corners(closed, face)) / 6;
  }
  std::stable_sort(out.begin(), out.end(), [](const Shell& a, const Shell& b) {
    return std::fabs(a.volume) > std::fabs(b.volume);
  });
  return out;
}

}  // namespace vug::mesh
