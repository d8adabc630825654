// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/opaque.h>
#include <vug/passages/nearest_first.h>
#include <vug/passages/water/polytopes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace vug::passages {
namespace {

using field::Gradient;

/// The largest signed distance to a side of the box: a lower bound of the field of a polytope in
/// it.
Gradient beyond(const Box3d& box, const Vec3d& p) {
  Gradient out{-kInfinity, {0, 0, 0}};
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      const double value = high ? p[axis] - box.max[axis] : box.min[axis] - p[axis];
      if (value <= out.value) continue;
      out.value = value;
      out.gradient = Vec3d(0.0);
      out.gradient[axis] = high ? 1 : -1;
    }
  return out;
}

Gradient sample_one(const Polytope& part, const Vec3d& p) {
  Gradient out = beyond(part.box, p);
  for (const HalfSpace& face : part.faces) {
    const double value = face.normal.dot(p) - face.offset;
    if (value > out.value) out = {value, face.normal};
  }
  return out;
}

/// A BVH whose leaves are single polytopes.
class PolytopeUnion {
 public:
  explicit PolytopeUnion(std::vector<Polytope> parts) : parts_(std::move(parts)) {
    order_.resize(parts_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.push_back({});
    build(0, 0, static_cast<uint32_t>(parts_.size()));
  }

  Gradient sample(const Vec3d& p) const {
    Gradient best{kInfinity, {0, 1, 0}};
    visit_nearest_first(
        nodes_, best.value, [&](const Node& node) { return beyond(node.box, p).value; },
        [&](const Node& leaf) {
          const Gradient here = sample_one(parts_[leaf.part], p);
          if (here.value < best.value) best = here;
        });
    return best;
  }
  const Box3d& bounds() const { return nodes_[0].box; }

  void add_to(Digester& digester) const { digester(parts_); }

 private:
  struct Node {
    Box3d box;
    uint32_t left = 0;  // Index of the left child, whose sibling follows; 0 for a leaf.
    uint32_t part = 0;
  };

  void build(uint32_t node, uint32_t first, uint32_t count) {
    for (uint32_t i = first; i < first + count; ++i)
      nodes_[node].box = united(nodes_[node].box, parts_[order_[i]].box);
    if (count == 1) {
      nodes_[node].part = order_[first];
      return;
    }
    const Vec3d size = nodes_[node].box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.z >= size.y ? 2 : 1);
    const auto begin = order_.begin() + first;
    std::sort(begin, begin + count, [&](uint32_t a, uint32_t b) {
      const double x = parts_[a].box.center()[axis], y = parts_[b].box.center()[axis];
      return x != y ? x < y : a < b;
    });
    const auto left = static_cast<uint32_t>(nodes_.size());
    nodes_[node].left = left;
    nodes_.resize(nodes_.size() + 2);
    build(left, first, count / 2);
    build(left + 1, first + count / 2, count - count / 2);
  }

  std::vector<Polytope> parts_;
  std::vector<uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace

field::Field polytopes(std::string name, std::vector<Polytope> parts) {
  if (parts.empty()) return field::empty();
  PolytopeUnion source(std::move(parts));
  field::Traits traits;
  traits.exactness = field::Exactness::bound;
  traits.bounds = source.bounds();
  // Beyond a corner of a box, the largest of three differences is at least this part of the
  // distance.
  traits.growth = 1 / std::sqrt(3.0);
  return field::Field(std::make_shared<field::OpaqueNode<PolytopeUnion>>(
      std::move(name), std::move(traits), std::move(source)));
}

}  // namespace vug::passages
