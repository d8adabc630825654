// SPDX-License-Identifier: Apache-2.0
// A bounding volume hierarchy (BVH) of triangles with eight children per node, for rays that are
// traced several at a time.
#pragma once

#include <vug/base/uninitialized_vector.h>
#include <vug/mesh/mesh.h>
#include <vug/raytree/ray.h>

#include <array>
#include <cstddef>
#include <vector>

namespace vug::raytree {

/// A node holds the boxes of eight children in two cache lines, and a leaf two quads in two: since
/// incoherent rays wait for memory, a ray requests two lines at a time (see BvhTraversal). Boxes
/// are quantised relative to their parent's, as in Ylitie, Karras, Laine 2017, "Efficient
/// incoherent ray traversal on GPUs through compressed wide BVHs" (cite ylitie2017compressed).
/// Corners are not quantised: neighbours have the same coordinates at their common edge, so no ray
/// passes between them.
class WideBvh {
 public:
  /// A mesh, and the caller's identifier for it, below 2^30.
  struct Geometry {
    mesh::MeshPtr mesh;
    uint32_t id = 0;
  };

  struct alignas(64) Node {
    std::array<float, 4> origin, step;             ///< The grid of the planes; x, y, z.
    std::array<uint32_t, 8> child;                 ///< A node, or a leaf if kLeaf is set.
    std::array<std::array<uint8_t, 8>, 6> planes;  ///< Minimum x, y, z, then maximum.
  };
  /// Four triangles: corners 0, 1, 3 of two quads, then corners 2, 3, 1.
  struct alignas(64) Leaf {
    /// x, y, z of the first and second corners. The third corners are `v1` with its pairs swapped.
    std::array<std::array<float, 4>, 3> v0, v1;
    std::array<uint32_t, 4> triangle;
    std::array<uint32_t, 4> geometry;  ///< Geometry::id; above kTurnShift bits Quad::Half::turn.
  };
  static constexpr uint32_t kLeaf = 1u << 31;
  static constexpr uint32_t kTurnShift = 30;
  /// Entries that a traversal stack needs at most.
  static constexpr size_t kStackSize = 512;

  /// Empty.
  WideBvh() = default;
  /// Builds the same tree on every machine. Triangles with a NaN or infinite corner, and their
  /// partners in a quad, are skipped. Throws Error(too_large) if memory runs out.
  explicit WideBvh(const std::vector<Geometry>& geometries);

  bool empty() const { return nodes_.empty(); }
  const Node& node(uint32_t number) const { return nodes_[number]; }
  const Leaf& leaf(uint32_t number) const { return leaves_[number & ~kLeaf]; }
  /// The memory of a node or leaf, to prefetch it.
  const void* address(uint32_t child) const {
    const bool is_leaf = (child & kLeaf) != 0;
    return is_leaf ? static_cast<const void*>(leaves_.data() + (child & ~kLeaf))
                   : static_cast<const void*>(nodes_.data() + child);
  }
  /// The largest absolute coordinate of all corners.
  float extent() const { return extent_; }
  size_t bytes() const { return nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(Leaf); }

 private:
  class Builder;
  UninitializedVector<Node> nodes_;
  UninitializedVector<Leaf> leaves_;  ///< The first is empty, for unused child slots.
  float extent_ = 0;
};

}  // namespace vug::raytree
