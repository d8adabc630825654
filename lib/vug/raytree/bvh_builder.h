// SPDX-License-Identifier: Apache-2.0
// The build plan of a WideBvh: which quads share a leaf, and which boxes share a node.
#pragma once

#include <vug/raytree/embree_device.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vug::raytree {

/// Embree splits the boxes of quads by the surface area heuristic into a binary tree with leaves of
/// up to two quads. The binary nodes are then collapsed into nodes of eight with the least expected
/// number of node visits (Ylitie, Karras, Laine 2017, "Efficient incoherent ray traversal on GPUs
/// through compressed wide BVHs", section 3.1, cite ylitie2017compressed). A collapse from the top
/// down would leave half of the child slots empty.
class BvhBuilder {
 public:
  static constexpr size_t kChildren = 8, kQuads = 2;
  /// Limit of the tree's depth.
  static constexpr unsigned kDepth = 64;

  struct Box {
    std::array<float, 3> min, max;
  };
  /// A leaf or an inner node.
  struct BuildNode {
    Box box;
    uint32_t quads = 0;  ///< Number of quads of a leaf; 0 for an inner node.
  };
  struct Leaf : BuildNode {
    std::array<std::pair<uint32_t, uint32_t>, kQuads> quad;  ///< geomID and primID of its box.
  };
  struct Children {
    std::array<const BuildNode*, kChildren> nodes;
    size_t count = 0;

    const BuildNode* const* begin() const { return nodes.data(); }
    const BuildNode* const* end() const { return nodes.data() + count; }
  };

  /// Builds the same tree on every machine. Throws as EmbreeDevice::check does.
  explicit BvhBuilder(std::vector<RTCBuildPrimitive> boxes);

  /// Null without boxes.
  const BuildNode* root() const { return root_; }
  size_t leaves() const { return leaves_; }
  /// The two to eight children of an inner node.
  static Children children(const BuildNode& node);

 private:
  struct BinaryNode;
  struct Callbacks;
  struct Release {
    void operator()(RTCBVH memory) const { rtcReleaseBVH(memory); }
  };

  EmbreeDevice device_;
  std::unique_ptr<std::remove_pointer_t<RTCBVH>, Release> memory_;  ///< Holds all nodes.
  const BuildNode* root_ = nullptr;
  size_t leaves_ = 0;
};

}  // namespace vug::raytree
