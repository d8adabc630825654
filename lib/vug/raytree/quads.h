// SPDX-License-Identifier: Apache-2.0
// Pairs of adjacent triangles: two triangles that share an edge are stored in one box and with four
// corners instead of six.
#pragma once

#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::raytree {

/// Two triangles: corners (0, 1, 3) and (2, 3, 1). A triangle without a partner repeats its last
/// corner, and its second half is kNoTriangle.
struct Quad {
  /// A triangle of the mesh and its rotation: corner k of the half is corner (k + turn) % 3 of the
  /// mesh's triangle.
  struct Half {
    uint32_t triangle = kNoTriangle;
    uint32_t turn = 0;
  };
  static constexpr uint32_t kNoTriangle = ~0u;

  std::array<uint32_t, 4> corners;
  std::array<Half, 2> halves;
};

/// Returns each triangle once. In order, each triangle is paired with the free neighbour across the
/// longest possible edge, so that quads are roughly square; both must have the same orientation.
std::vector<Quad> pair_triangles(const mesh::Mesh& mesh);

}  // namespace vug::raytree
