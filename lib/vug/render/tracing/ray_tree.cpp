#include <vug/base/error.h>
#include <vug/render/embree_device.h>
#include <vug/render/tracing/quads.h>
#include <vug/render/tracing/ray_tree.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vug::render {
namespace {

constexpr unsigned kChildren = 8, kQuads = 2, kDepth = 24;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// Pages of 2 MiB where it is worth it.
template <class T>
T* lines(size_t count) {
  constexpr size_t kPage = size_t{2} << 20;
  const size_t line = count * sizeof(T) < kPage ? alignof(T) : kPage;
  const size_t bytes = (count * sizeof(T) + line - 1) / line * line;
  void* const memory = std::aligned_alloc(line, bytes);
  if (!memory) throw Error(ErrorCode::too_large, "no memory for the tree of triangles");
  if (line == kPage) madvise(memory, bytes, MADV_HUGEPAGE);  // a wish
  return static_cast<T*>(memory);
}

struct Box {
  std::array<float, 3> min, max;
};
Box box_of(const RTCBounds& b) {
  return {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
}

/// What Embree's builder makes: a few quads or some boxes.
struct Draft {
  unsigned quads = 0;  ///< 0: it is a branch.
};
struct DraftLeaf : Draft {
  std::array<std::pair<uint32_t, uint32_t>, kQuads> quad;  ///< Part and quad.
};
struct DraftBranch : Draft {
  unsigned count = 0;
  std::array<Box, kChildren> boxes;
  std::array<const Draft*, kChildren> children;
};

template <class T>
T* draft(RTCThreadLocalAllocator allocator) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(T), 16)) T();
}
void* new_branch(RTCThreadLocalAllocator allocator, unsigned count, void*) {
  auto* made = draft<DraftBranch>(allocator);
  made->count = count;
  return static_cast<Draft*>(made);
}
void set_children(void* branch, void** children, unsigned count, void*) {
  auto& made = static_cast<DraftBranch&>(*static_cast<Draft*>(branch));
  for (unsigned i = 0; i < count; ++i) made.children[i] = static_cast<Draft*>(children[i]);
}
void set_boxes(void* branch, const RTCBounds** boxes, unsigned count, void*) {
  auto& made = static_cast<DraftBranch&>(*static_cast<Draft*>(branch));
  for (unsigned i = 0; i < count; ++i) made.boxes[i] = box_of(*boxes[i]);
}
void* new_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* all, size_t count,
               void* leaves) {
  auto* made = draft<DraftLeaf>(allocator);
  made->quads = static_cast<unsigned>(count);
  for (size_t i = 0; i < count; ++i) made->quad[i] = {all[i].geomID, all[i].primID};
  ++*static_cast<size_t*>(leaves);
  return static_cast<Draft*>(made);
}

}  // namespace

void RayTree::Free::operator()(void* memory) const { std::free(memory); }

class RayTree::Builder {
 public:
  Builder(RayTree& tree, const std::vector<Part>& parts) : tree_(tree), parts_(parts) {
    for (const Part& part : parts) quads_.push_back(paired(*part.mesh));
    EmbreeDevice device;
    const RTCBVH drafts = rtcNewBVH(device.get());
    const auto release = [](RTCBVH all) { rtcReleaseBVH(all); };
    const std::unique_ptr<std::remove_pointer_t<RTCBVH>, decltype(release)> held(drafts, release);
    const Draft* const root = draw(drafts);
    device.check("building the tree of triangles");
    if (root) write(root);
  }

 private:
  std::vector<RTCBuildPrimitive> boxes() {
    size_t count = 0;
    for (const auto& quads : quads_) count += quads.size();
    std::vector<RTCBuildPrimitive> all;
    all.reserve(count);
    for (uint32_t part = 0; part < parts_.size(); ++part)
      for (uint32_t quad = 0; quad < quads_[part].size(); ++quad) {
        Box3f box;
        bool finite = true;
        for (const uint32_t corner : quads_[part][quad].corners) {
          const Vec3f& p = parts_[part].mesh->positions[corner];
          box.extendBy(p);
          for (int axis = 0; axis < 3; ++axis) {
            finite = finite && std::isfinite(p[axis]);
            tree_.extent_ =
                std::max(tree_.extent_, std::isfinite(p[axis]) ? std::fabs(p[axis]) : 0);
          }
        }
        if (finite)
          all.push_back(
              {box.min.x, box.min.y, box.min.z, part, box.max.x, box.max.y, box.max.z, quad});
      }
    return all;
  }

  const Draft* draw(RTCBVH drafts) {
    std::vector<RTCBuildPrimitive> all = boxes();
    if (all.empty()) return nullptr;
    RTCBuildArguments plan = rtcDefaultBuildArguments();
    plan.bvh = drafts;
    plan.maxBranchingFactor = kChildren, plan.maxDepth = kDepth;
    plan.sahBlockSize = plan.minLeafSize = plan.maxLeafSize = kQuads;
    plan.primitives = all.data(), plan.primitiveCount = plan.primitiveArrayCapacity = all.size();
    plan.createNode = new_branch, plan.setNodeChildren = set_children;
    plan.setNodeBounds = set_boxes, plan.createLeaf = new_leaf;
    plan.userPtr = &leaves_;
    tbb::task_arena alone(1);  // one thread makes the same drafts in the same order
    void* root = nullptr;
    alone.execute([&] { root = rtcBuildBVH(&plan); });
    return static_cast<const Draft*>(root);
  }

  void write(const Draft* root) {
    const size_t branches = count(root);
    tree_.leaves_.reset(lines<Leaf>(leaves_ + 1));
    tree_.nodes_.reset(lines<Node>(branches));
    write_leaf({});
    // Depth first, so that what lies together in space does in memory, too.
    std::vector<std::pair<const Draft*, size_t>> todo;
    tree_.node_count_ = 1;
    if (root->quads > 0) {
      DraftBranch around;
      around.count = 1;
      around.boxes[0] = box(static_cast<const DraftLeaf&>(*root));
      around.children[0] = root;
      write_node(around, 0, todo);
      return;
    }
    todo.emplace_back(root, 0);
    while (!todo.empty()) {
      const auto [branch, at] = todo.back();
      todo.pop_back();
      write_node(static_cast<const DraftBranch&>(*branch), at, todo);
    }
  }

  static size_t count(const Draft* root) {
    if (root->quads > 0) return 1;
    size_t branches = 0;
    std::vector<const Draft*> todo{root};
    while (!todo.empty()) {
      const auto& branch = static_cast<const DraftBranch&>(*todo.back());
      todo.pop_back();
      ++branches;
      for (unsigned i = 0; i < branch.count; ++i)
        if (branch.children[i]->quads == 0) todo.push_back(branch.children[i]);
    }
    return branches;
  }

  Box box(const DraftLeaf& leaf) const {
    Box3f around;
    for (unsigned i = 0; i < leaf.quads; ++i) {
      const auto [part, quad] = leaf.quad[i];
      for (const uint32_t corner : quads_[part][quad].corners)
        around.extendBy(parts_[part].mesh->positions[corner]);
    }
    return {{around.min.x, around.min.y, around.min.z}, {around.max.x, around.max.y, around.max.z}};
  }

  void write_node(const DraftBranch& branch, size_t at,
                  std::vector<std::pair<const Draft*, size_t>>& todo) {
    Node& node = tree_.nodes_[at];
    node = {};
    for (size_t axis = 0; axis < 3; ++axis) {
      float least = branch.boxes[0].min[axis], greatest = branch.boxes[0].max[axis];
      for (unsigned i = 1; i < branch.count; ++i) {
        least = std::min(least, branch.boxes[i].min[axis]);
        greatest = std::max(greatest, branch.boxes[i].max[axis]);
      }
      const double size = static_cast<double>(greatest) - static_cast<double>(least);
      node.origin[axis] = least;
      node.step[axis] = std::nextafter(static_cast<float>(size / 255), HUGE_VALF);
      const auto planes_off = [&](float place) {
        return (static_cast<double>(place) - static_cast<double>(least)) /
               static_cast<double>(node.step[axis]);
      };
      for (unsigned i = 0; i < branch.count; ++i) {
        const double low = std::floor(planes_off(branch.boxes[i].min[axis]));
        const double high = std::ceil(planes_off(branch.boxes[i].max[axis]));
        node.planes[axis][i] = static_cast<uint8_t>(std::clamp(low, 0.0, 255.0));
        node.planes[axis + 3][i] = static_cast<uint8_t>(std::clamp(high, 0.0, 255.0));
      }
      for (unsigned i = branch.count; i < kChildren; ++i) node.planes[axis][i] = 255;
    }
    // No ray meets a child that is not there; but for rounding, where all boxes are one point.
    node.child.fill(kLeaf);
    for (unsigned i = 0; i < branch.count; ++i) {
      const Draft* const child = branch.children[i];
      if (child->quads > 0) {
        node.child[i] = write_leaf(static_cast<const DraftLeaf&>(*child));
      } else {
        node.child[i] = static_cast<uint32_t>(tree_.node_count_);
        todo.emplace_back(child, tree_.node_count_++);
      }
    }
  }

  uint32_t write_leaf(const DraftLeaf& from) {
    Leaf& leaf = tree_.leaves_[tree_.leaf_count_];
    for (size_t axis = 0; axis < 3; ++axis)
      leaf.start[axis].fill(kNothing), leaf.second[axis].fill(kNothing);
    leaf.triangle.fill(0), leaf.part.fill(0);
    for (size_t i = 0; i < from.quads; ++i) {
      const auto [number, which] = from.quad[i];
      const Part& part = parts_[number];
      const Quad& quad = quads_[number][which];
      const auto corner = [&](size_t k) { return part.mesh->positions[quad.corners[k]]; };
      for (size_t half = 0; half < 2; ++half) {
        const size_t lane = i + kQuads * half;
        const Vec3f start = corner(2 * half), second = corner(2 * half + 1);
        for (size_t axis = 0; axis < 3; ++axis) {
          leaf.start[axis][lane] = start[static_cast<int>(axis)];
          leaf.second[axis][lane] = second[static_cast<int>(axis)];
        }
        leaf.triangle[lane] = quad.halves[half].triangle;
        leaf.part[lane] = part.number | quad.halves[half].turn << kTurn;
      }
    }
    return kLeaf | static_cast<uint32_t>(tree_.leaf_count_++);
  }

  RayTree& tree_;
  const std::vector<Part>& parts_;
  std::vector<std::vector<Quad>> quads_;
  size_t leaves_ = 0;
};

RayTree::RayTree(const std::vector<Part>& parts) { Builder(*this, parts); }

}  // namespace vug::render
