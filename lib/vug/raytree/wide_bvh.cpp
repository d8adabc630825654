#include <vug/raytree/quads.h>
#include <vug/raytree/wide_bvh.h>
#include <vug/raytree/bvh_builder.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::render {
namespace {

constexpr size_t kChildren = TreePlan::kChildren, kQuads = TreePlan::kQuads;
static_assert(TreePlan::kDepth * (kChildren - 1) + kChildren <= RayTree::kMostWaiting);
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

}  // namespace

class RayTree::Builder {
 public:
  Builder(RayTree& tree, const std::vector<Part>& parts) : tree_(tree), parts_(parts) {
    for (const Part& part : parts) quads_.push_back(paired(*part.mesh));
    const TreePlan plan(boxes());
    if (plan.root()) write(plan);
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

  /// Nodes that wait to be written, and where.
  using Todo = std::vector<std::pair<const TreePlan::Part*, size_t>>;

  void write(const TreePlan& plan) {
    const TreePlan::Part& root = *plan.root();
    tree_.leaves_.reserve(plan.leaves() + 1);
    tree_.nodes_.reserve(plan.leaves());  // each has two children or more: enough, even for a leaf
    write_leaf({});
    // Depth first, so that what lies together in space does in memory, too.
    Todo todo;
    tree_.nodes_.resize(1);
    if (root.quads > 0) return write_node({{&root}, 1}, 0, todo);
    todo.emplace_back(&root, 0);
    while (!todo.empty()) {
      const auto [node, at] = todo.back();
      todo.pop_back();
      write_node(TreePlan::children(*node), at, todo);
    }
  }

  void write_node(const TreePlan::Children& children, size_t at, Todo& todo) {
    Node& node = tree_.nodes_[at];
    node = {};
    for (size_t axis = 0; axis < 3; ++axis) {
      float least = children.all[0]->box.min[axis], greatest = children.all[0]->box.max[axis];
      for (const TreePlan::Part* child : children) {
        least = std::min(least, child->box.min[axis]);
        greatest = std::max(greatest, child->box.max[axis]);
      }
      const double size = static_cast<double>(greatest) - static_cast<double>(least);
      node.origin[axis] = least;
      node.step[axis] = std::nextafter(static_cast<float>(size / 255), HUGE_VALF);
      const auto planes_off = [&](float place) {
        return (static_cast<double>(place) - static_cast<double>(least)) /
               static_cast<double>(node.step[axis]);
      };
      for (size_t i = 0; i < children.count; ++i) {
        const double low = std::floor(planes_off(children.all[i]->box.min[axis]));
        const double high = std::ceil(planes_off(children.all[i]->box.max[axis]));
        node.planes[axis][i] = static_cast<uint8_t>(std::clamp(low, 0.0, 255.0));
        node.planes[axis + 3][i] = static_cast<uint8_t>(std::clamp(high, 0.0, 255.0));
      }
      for (size_t i = children.count; i < kChildren; ++i) node.planes[axis][i] = 255;
    }
    // No ray meets a child that is not there; but for rounding, where all boxes are one point.
    node.child.fill(kLeaf);
    for (size_t i = 0; i < children.count; ++i) {
      const TreePlan::Part* const child = children.all[i];
      if (child->quads > 0) {
        node.child[i] = write_leaf(static_cast<const TreePlan::Leaf&>(*child));
      } else {
        node.child[i] = static_cast<uint32_t>(tree_.nodes_.size());
        todo.emplace_back(child, tree_.nodes_.size());
        tree_.nodes_.emplace_back();
      }
    }
  }

  uint32_t write_leaf(const TreePlan::Leaf& from) {
    const size_t at = tree_.leaves_.size();
    Leaf& leaf = tree_.leaves_.emplace_back();
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
    return kLeaf | static_cast<uint32_t>(at);
  }

  RayTree& tree_;
  const std::vector<Part>& parts_;
  std::vector<std::vector<Quad>> quads_;
};

RayTree::RayTree(const std::vector<Part>& parts) { Builder(*this, parts); }

}  // namespace vug::render
