// SPDX-License-Identifier: Apache-2.0
#include <vug/raytree/bvh_builder.h>

#include <tbb/task_arena.h>

#include <algorithm>

namespace vug::raytree {
namespace {

/// Limit of one node's area, so that the sum over all possible nodes stays finite.
constexpr double kMaxArea = 1e28;

BvhBuilder::Box united(const BvhBuilder::Box& a, const BvhBuilder::Box& b) {
  BvhBuilder::Box both{};
  for (size_t axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::min(a.min[axis], b.min[axis]);
    both.max[axis] = std::max(a.max[axis], b.max[axis]);
  }
  return both;
}

float half_area(const BvhBuilder::Box& box) {
  std::array<double, 3> size{};
  for (size_t axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<double>(box.max[axis]) - static_cast<double>(box.min[axis]);
  const double area = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  return static_cast<float>(std::min(area, kMaxArea));
}

}  // namespace

/// A node of Embree's binary tree, with the best ways to collapse it into up to eight children.
struct BvhBuilder::BinaryNode : BuildNode {
  std::array<const BuildNode*, 2> halves;
  /// The total area of the wide nodes in this subtree if it contributes 1 to 7 children to another
  /// wide node; with 1 it is a wide node itself. Leaves cost nothing, since they exist either way.
  std::array<float, kChildren> cost;
  /// The number of children that come from the first half; 0 if one child fewer is better. Entry 0
  /// is for the node's own eight children.
  std::array<uint8_t, kChildren> first;

  void compute_costs() {
    box = united(halves[0]->box, halves[1]->box);
    cost[0] = 0;
    cost[1] = half_area(box) + split_cost(kChildren, first[0]);
    first[1] = 0;
    for (size_t count = 2; count < kChildren; ++count) {
      cost[count] = split_cost(count, first[count]);
      if (!(cost[count] < cost[count - 1])) cost[count] = cost[count - 1], first[count] = 0;
    }
  }
  void collect(size_t count, size_t from_first, Children& out) const {
    add(*halves[0], from_first, out);
    add(*halves[1], count - from_first, out);
  }

 private:
  static float cost_of(const BuildNode& node, size_t count) {
    return node.quads > 0 ? 0 : static_cast<const BinaryNode&>(node).cost[count];
  }
  float split_cost(size_t count, uint8_t& from_first) const {
    float least = 0;
    from_first = 0;
    for (size_t k = 1; k < count; ++k) {
      const float sum = cost_of(*halves[0], k) + cost_of(*halves[1], count - k);
      if (from_first == 0 || sum < least) least = sum, from_first = static_cast<uint8_t>(k);
    }
    return least;
  }
  static void add(const BuildNode& child, size_t count, Children& out) {
    if (child.quads == 0) {
      const auto& node = static_cast<const BinaryNode&>(child);
      while (count > 1 && node.first[count] == 0) --count;
      if (count > 1) return node.collect(count, node.first[count], out);
    }
    out.nodes[out.count++] = &child;
  }
};

/// The callbacks of Embree's builder; it calls `set_children` after the subtrees are complete.
struct BvhBuilder::Callbacks {
  template <class T>
  static T* make(RTCThreadLocalAllocator allocator) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(T), 16)) T();
  }
  static void* make_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return static_cast<BuildNode*>(make<BinaryNode>(allocator));
  }
  static void set_bounds(void*, const RTCBounds**, unsigned, void*) {}  // computed from the leaves
  static void set_children(void* parent, void** halves, unsigned, void*) {
    auto& node = static_cast<BinaryNode&>(*static_cast<BuildNode*>(parent));
    node.halves = {static_cast<const BuildNode*>(halves[0]),
                   static_cast<const BuildNode*>(halves[1])};
    node.compute_costs();
  }
  static void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* quads,
                         size_t count, void* leaves) {
    auto* leaf = make<Leaf>(allocator);
    leaf->quads = static_cast<uint32_t>(count);
    for (size_t i = 0; i < count; ++i) {
      const RTCBuildPrimitive& quad = quads[i];
      const Box box{{quad.lower_x, quad.lower_y, quad.lower_z},
                    {quad.upper_x, quad.upper_y, quad.upper_z}};
      leaf->box = i == 0 ? box : united(leaf->box, box);
      leaf->quad[i] = {quad.geomID, quad.primID};
    }
    ++*static_cast<size_t*>(leaves);
    return static_cast<BuildNode*>(leaf);
  }
};

BvhBuilder::BvhBuilder(std::vector<RTCBuildPrimitive> boxes) : memory_(rtcNewBVH(device_.get())) {
  if (boxes.empty()) return;
  RTCBuildArguments build = rtcDefaultBuildArguments();
  build.bvh = memory_.get();
  build.maxBranchingFactor = 2, build.maxDepth = kDepth;
  build.sahBlockSize = build.minLeafSize = build.maxLeafSize = kQuads;
  build.primitives = boxes.data();
  build.primitiveCount = build.primitiveArrayCapacity = boxes.size();
  build.createNode = Callbacks::make_node, build.setNodeChildren = Callbacks::set_children;
  build.setNodeBounds = Callbacks::set_bounds, build.createLeaf = Callbacks::make_leaf;
  build.userPtr = &leaves_;
  tbb::task_arena alone(1);  // a single thread builds the same tree in the same order
  void* root = nullptr;
  alone.execute([&] { root = rtcBuildBVH(&build); });
  device_.check("building the BVH");
  root_ = static_cast<const BuildNode*>(root);
}

BvhBuilder::Children BvhBuilder::children(const BuildNode& node) {
  const auto& binary = static_cast<const BinaryNode&>(node);
  Children out;
  binary.collect(kChildren, binary.first[0], out);
  return out;
}

}  // namespace vug::raytree
