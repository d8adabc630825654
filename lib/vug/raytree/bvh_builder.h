// The plan of a RayTree: which quads share a leaf, and which boxes share a node.
#pragma once

#include <vug/raytree/embree_device.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vug::render {

/// Embree parts the boxes of quads in two by their surface areas, down to leaves of two; of these
/// pairs nodes of eight are made such that rays meet as few as can be (Ylitie, Karras, Laine 2017,
/// "Efficient incoherent ray traversal on GPUs through compressed wide BVHs", section 3.1, cite
/// ylitie2017compressed). Nodes that are parted from the top down leave half of their places empty.
class TreePlan {
 public:
  static constexpr size_t kChildren = 8, kQuads = 2;
  /// No path of nodes is longer.
  static constexpr unsigned kDepth = 64;

  struct Box {
    std::array<float, 3> min, max;
  };
  /// A leaf or a node.
  struct Part {
    Box box;
    uint32_t quads = 0;  ///< 0: it is a node.
  };
  struct Leaf : Part {
    std::array<std::pair<uint32_t, uint32_t>, kQuads> quad;  ///< geomID and primID of its box.
  };
  struct Children {
    std::array<const Part*, kChildren> all;
    size_t count = 0;

    const Part* const* begin() const { return all.data(); }
    const Part* const* end() const { return all.data() + count; }
  };

  /// The same plan on every machine; the order of the boxes is lost. Throws as EmbreeDevice::check.
  explicit TreePlan(std::vector<RTCBuildPrimitive> boxes);

  /// Null without boxes.
  const Part* root() const { return root_; }
  size_t leaves() const { return leaves_; }
  /// Of a node.
  static Children children(const Part& node);

 private:
  struct Node;
  struct Callbacks;
  struct Release {
    void operator()(RTCBVH memory) const { rtcReleaseBVH(memory); }
  };

  EmbreeDevice device_;
  std::unique_ptr<std::remove_pointer_t<RTCBVH>, Release> memory_;  ///< Of all parts.
  const Part* root_ = nullptr;
  size_t leaves_ = 0;
};

}  // namespace vug::render
