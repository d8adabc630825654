// A tree of triangles for rays that are traced several at a time.
#pragma once

#include <vug/base/uninitialized_vector.h>
#include <vug/mesh/mesh.h>
#include <vug/render/vectors.h>

#include <array>
#include <cstddef>
#include <vector>

namespace vug::render {

/// Boxes of eight children in two lines of memory, two quads in two more: memory is what incoherent
/// rays wait for, so a ray asks for two lines at a time (see RaySearch). Boxes are stored in parts
/// of their parent's, as in Ylitie, Karras, Laine 2017, "Efficient incoherent ray traversal on GPUs
/// through compressed wide BVHs" (cite ylitie2017compressed). Corners are kept as they are:
/// neighbours see the same numbers at their edge, so no ray slips through between them.
class RayTree {
 public:
  /// A mesh, and the caller's number for it, below 2^30.
  struct Part {
    mesh::MeshPtr mesh;
    uint32_t number = 0;
  };

  struct alignas(64) Node {
    std::array<float, 4> origin, step;             ///< Of the grid that planes are on; x, y, z.
    std::array<uint32_t, 8> child;                 ///< A node, or with kLeaf a leaf.
    std::array<std::array<uint8_t, 8>, 6> planes;  ///< Least x, y, z, then greatest.
  };
  /// Four triangles: corners 0, 1, 3 of two quads, then corners 2, 3, 1.
  struct alignas(64) Leaf {
    std::array<std::array<float, 4>, 3> start,
        second;  ///< x, y, z; the third are `second`, turned.
    std::array<uint32_t, 4> triangle;
    std::array<uint32_t, 4> part;  ///< And above kTurn bits Quad::Half::turn.
  };
  static constexpr uint32_t kLeaf = 1u << 31;
  static constexpr uint32_t kTurn = 30;
  /// Children to look at on the way to the deepest leaf are at most so many.
  static constexpr size_t kMostWaiting = 512;

  /// Empty.
  RayTree() = default;
  /// The same tree on every machine. Corners that are no numbers are left out. Throws
  /// Error(too_large) when memory runs out.
  explicit RayTree(const std::vector<Part>& parts);

  bool empty() const { return nodes_.empty(); }
  const Node& node(uint32_t number) const { return nodes_[number]; }
  const Leaf& leaf(uint32_t number) const { return leaves_[number & ~kLeaf]; }
  /// The largest coordinate of any corner.
  float extent() const { return extent_; }
  size_t bytes() const { return nodes_.size() * sizeof(Node) + leaves_.size() * sizeof(Leaf); }

 private:
  class Builder;
  UninitializedVector<Node> nodes_;
  UninitializedVector<Leaf> leaves_;  ///< The first is empty: where nodes have no child.
  float extent_ = 0;
};

}  // namespace vug::render
