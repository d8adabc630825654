// Triangles of a mesh in pairs: two that share an edge lie in one box and have four corners
// instead of six.
#pragma once

#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::render {

/// Two triangles, (0, 1, 3) and (2, 3, 1) of its corners. One without a partner has its last corner
/// twice, and its second triangle is no triangle.
struct Quad {
  /// A triangle of the mesh, and at which of its corners the quad begins it: the k-th of the quad's
  /// is corner (k + turn) % 3 of the mesh's.
  struct Half {
    uint32_t triangle = kNoTriangle;
    uint32_t turn = 0;
  };
  static constexpr uint32_t kNoTriangle = ~0u;

  std::array<uint32_t, 4> corners;
  std::array<Half, 2> halves;
};

/// Each triangle once. In the order of triangles, each takes the neighbour that is free and beyond
/// its longest edge, so that quads are about square; neighbours go round the same way.
std::vector<Quad> paired(const mesh::Mesh& mesh);

}  // namespace vug::render
