// SPDX-License-Identifier: Apache-2.0
#include <vug/raytree/bvh_builder.h>
#include <vug/raytree/quads.h>
#include <vug/raytree/wide_bvh.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::raytree {
namespace {

constexpr size_t kChildren = BvhBuilder::kChildren, kQuads = BvhBuilder::kQuads;
static_assert(BvhBuilder::kDepth * (kChildren - 1) + kChildren <= WideBvh::kStackSize);
constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();

}  // namespace

class WideBvh::Builder {
 public:
  Builder(WideBvh& bvh, const std::vector<Geometry>& geometries)
      : bvh_(bvh), geometries_(geometries) {
    for (const Geometry& each : geometries) quads_.push_back(pair_triangles(*each.mesh));
    const BvhBuilder plan(boxes());
    if (plan.root()) write(plan);
  }

 private:
  std::vector<RTCBuildPrimitive> boxes() {
    size_t count = 0;
    for (const auto& quads : quads_) count += quads.size();
    std::vector<RTCBuildPrimitive> all;
    all.reserve(count);
    for (uint32_t geometry = 0; geometry < geometries_.size(); ++geometry)
      for (uint32_t quad = 0; quad < quads_[geometry].size(); ++quad) {
        Box3f box;
        bool finite = true;
        for (const uint32_t corner : quads_[geometry][quad].corners) {
          const Vec3f& p = geometries_[geometry].mesh->positions[corner];
          box.extendBy(p);
          for (int axis = 0; axis < 3; ++axis) {
            finite = finite && std::isfinite(p[axis]);
            bvh_.extent_ = std::max(bvh_.extent_, std::isfinite(p[axis]) ? std::fabs(p[axis]) : 0);
          }
        }
        if (finite)
          all.push_back(
              {box.min.x, box.min.y, box.min.z, geometry, box.max.x, box.max.y, box.max.z, quad});
      }
    return all;
  }

  /// Nodes still to be written, with their indices.
  using Todo = std::vector<std::pair<const BvhBuilder::BuildNode*, size_t>>;

  void write(const BvhBuilder& plan) {
    const BvhBuilder::BuildNode& root = *plan.root();
    bvh_.leaves_.reserve(plan.leaves() + 1);
    bvh_.nodes_.reserve(plan.leaves());  // each has two or more children, so this suffices
    write_leaf({});
    // Depth first, so that nodes that are close in space are close in memory.
    Todo todo;
    bvh_.nodes_.resize(1);
    if (root.quads > 0) return write_node({{&root}, 1}, 0, todo);
    todo.emplace_back(&root, 0);
    while (!todo.empty()) {
      const auto [node, at] = todo.back();
      todo.pop_back();
      write_node(BvhBuilder::children(*node), at, todo);
    }
  }

  void write_node(const BvhBuilder::Children& children, size_t at, Todo& todo) {
    Node& node = bvh_.nodes_[at];
    node = {};
    for (size_t axis = 0; axis < 3; ++axis) {
      float least = children.nodes[0]->box.min[axis], greatest = children.nodes[0]->box.max[axis];
      for (const BvhBuilder::BuildNode* child : children) {
        least = std::min(least, child->box.min[axis]);
        greatest = std::max(greatest, child->box.max[axis]);
      }
      const double size = static_cast<double>(greatest) - static_cast<double>(least);
      node.origin[axis] = least;
      node.step[axis] = std::nextafter(static_cast<float>(size / 255), HUGE_VALF);
      const auto quantised = [&](float position) {
        return (static_cast<double>(position) - static_cast<double>(least)) /
               static_cast<double>(node.step[axis]);
      };
      for (size_t i = 0; i < children.count; ++i) {
        const double low = std::floor(quantised(children.nodes[i]->box.min[axis]));
        const double high = std::ceil(quantised(children.nodes[i]->box.max[axis]));
        node.planes[axis][i] = static_cast<uint8_t>(std::clamp(low, 0.0, 255.0));
        node.planes[axis + 3][i] = static_cast<uint8_t>(std::clamp(high, 0.0, 255.0));
      }
      for (size_t i = children.count; i < kChildren; ++i) node.planes[axis][i] = 255;
    }
    // No ray meets an unused slot, except by rounding where all boxes are a single point.
    node.child.fill(kLeaf);
    for (size_t i = 0; i < children.count; ++i) {
      const BvhBuilder::BuildNode* const child = children.nodes[i];
      if (child->quads > 0) {
        node.child[i] = write_leaf(static_cast<const BvhBuilder::Leaf&>(*child));
      } else {
        node.child[i] = static_cast<uint32_t>(bvh_.nodes_.size());
        todo.emplace_back(child, bvh_.nodes_.size());
        bvh_.nodes_.emplace_back();
      }
    }
  }

  uint32_t write_leaf(const BvhBuilder::Leaf& from) {
    const size_t at = bvh_.leaves_.size();
    Leaf& leaf = bvh_.leaves_.emplace_back();
    for (size_t axis = 0; axis < 3; ++axis) leaf.v0[axis].fill(kEmpty), leaf.v1[axis].fill(kEmpty);
    leaf.triangle.fill(0), leaf.geometry.fill(0);
    for (size_t i = 0; i < from.quads; ++i) {
      const auto [number, index] = from.quad[i];
      const Geometry& geometry = geometries_[number];
      const Quad& quad = quads_[number][index];
      const auto corner = [&](size_t k) { return geometry.mesh->positions[quad.corners[k]]; };
      for (size_t half = 0; half < 2; ++half) {
        const size_t lane = i + kQuads * half;
        const Vec3f v0 = corner(2 * half), v1 = corner(2 * half + 1);
        for (size_t axis = 0; axis < 3; ++axis) {
          leaf.v0[axis][lane] = v0[static_cast<int>(axis)];
          leaf.v1[axis][lane] = v1[static_cast<int>(axis)];
        }
        leaf.triangle[lane] = quad.halves[half].triangle;
        leaf.geometry[lane] = geometry.id | quad.halves[half].turn << kTurnShift;
      }
    }
    return kLeaf | static_cast<uint32_t>(at);
  }

  WideBvh& bvh_;
  const std::vector<Geometry>& geometries_;
  std::vector<std::vector<Quad>> quads_;
};

WideBvh::WideBvh(const std::vector<Geometry>& geometries) { Builder(*this, geometries); }

}  // namespace vug::raytree
