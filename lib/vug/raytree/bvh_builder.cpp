#include <vug/raytree/bvh_builder.h>

#include <tbb/task_arena.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Sums of that many, of all parts there can be, are still numbers.
constexpr double kMostArea = 1e28;

TreePlan::Box united(const TreePlan::Box& a, const TreePlan::Box& b) {
  TreePlan::Box both{};
  for (size_t axis = 0; axis < 3; ++axis) {
    both.min[axis] = std::min(a.min[axis], b.min[axis]);
    both.max[axis] = std::max(a.max[axis], b.max[axis]);
  }
  return both;
}

float half_area(const TreePlan::Box& box) {
  std::array<double, 3> size{};
  for (size_t axis = 0; axis < 3; ++axis)
    size[axis] = static_cast<double>(box.max[axis]) - static_cast<double>(box.min[axis]);
  const double area = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  return static_cast<float>(std::min(area, kMostArea));
}

}  // namespace

/// Two parts, and how they are best made into up to eight children.
struct TreePlan::Node : Part {
  std::array<const Part*, 2> halves;
  /// Areas of all nodes that are there when 1 to 7 children of another node are made of this one;
  /// with 1 it is a node itself. Leaves are there either way.
  std::array<float, kChildren> cost;
  /// How many of so many children come from the first half, 0: one less is better; [0] is of the
  /// eight of the node itself.
  std::array<uint8_t, kChildren> first;

  void plan() {
    box = united(halves[0]->box, halves[1]->box);
    cost[0] = 0;
    cost[1] = half_area(box) + parted(kChildren, first[0]);
    first[1] = 0;
    for (size_t count = 2; count < kChildren; ++count) {
      cost[count] = parted(count, first[count]);
      if (!(cost[count] < cost[count - 1])) cost[count] = cost[count - 1], first[count] = 0;
    }
  }
  void gather(size_t count, size_t from_first, Children& out) const {
    add(*halves[0], from_first, out);
    add(*halves[1], count - from_first, out);
  }

 private:
  static float cost_of(const Part& part, size_t count) {
    return part.quads > 0 ? 0 : static_cast<const Node&>(part).cost[count];
  }
  float parted(size_t count, uint8_t& from_first) const {
    float least = 0;
    from_first = 0;
    for (size_t k = 1; k < count; ++k) {
      const float sum = cost_of(*halves[0], k) + cost_of(*halves[1], count - k);
      if (from_first == 0 || sum < least) least = sum, from_first = static_cast<uint8_t>(k);
    }
    return least;
  }
  static void add(const Part& part, size_t count, Children& out) {
    if (part.quads == 0) {
      const auto& node = static_cast<const Node&>(part);
      while (count > 1 && node.first[count] == 0) --count;
      if (count > 1) return node.gather(count, node.first[count], out);
    }
    out.all[out.count++] = &part;
  }
};

/// What Embree's builder calls; for a node `join` when all below is done.
struct TreePlan::Callbacks {
  template <class T>
  static T* make(RTCThreadLocalAllocator allocator) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(T), 16)) T();
  }
  static void* make_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return static_cast<Part*>(make<Node>(allocator));
  }
  static void set_boxes(void*, const RTCBounds**, unsigned, void*) {}  // they have their own
  static void join(void* part, void** halves, unsigned, void*) {
    auto& node = static_cast<Node&>(*static_cast<Part*>(part));
    node.halves = {static_cast<const Part*>(halves[0]), static_cast<const Part*>(halves[1])};
    node.plan();
  }
  static void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* all,
                         size_t count, void* leaves) {
    auto* leaf = make<Leaf>(allocator);
    leaf->quads = static_cast<uint32_t>(count);
    for (size_t i = 0; i < count; ++i) {
      const RTCBuildPrimitive& quad = all[i];
      const Box box{{quad.lower_x, quad.lower_y, quad.lower_z},
                    {quad.upper_x, quad.upper_y, quad.upper_z}};
      leaf->box = i == 0 ? box : united(leaf->box, box);
      leaf->quad[i] = {quad.geomID, quad.primID};
    }
    ++*static_cast<size_t*>(leaves);
    return static_cast<Part*>(leaf);
  }
};

TreePlan::TreePlan(std::vector<RTCBuildPrimitive> boxes) : memory_(rtcNewBVH(device_.get())) {
  if (boxes.empty()) return;
  RTCBuildArguments plan = rtcDefaultBuildArguments();
  plan.bvh = memory_.get();
  plan.maxBranchingFactor = 2, plan.maxDepth = kDepth;
  plan.sahBlockSize = plan.minLeafSize = plan.maxLeafSize = kQuads;
  plan.primitives = boxes.data();
  plan.primitiveCount = plan.primitiveArrayCapacity = boxes.size();
  plan.createNode = Callbacks::make_node, plan.setNodeChildren = Callbacks::join;
  plan.setNodeBounds = Callbacks::set_boxes, plan.createLeaf = Callbacks::make_leaf;
  plan.userPtr = &leaves_;
  tbb::task_arena alone(1);  // one thread makes the same parts in the same order
  void* root = nullptr;
  alone.execute([&] { root = rtcBuildBVH(&plan); });
  device_.check("building the tree of triangles");
  root_ = static_cast<const Part*>(root);
}

TreePlan::Children TreePlan::children(const Part& part) {
  const auto& node = static_cast<const Node&>(part);
  Children out;
  node.gather(kChildren, node.first[0], out);
  return out;
}

}  // namespace vug::render
