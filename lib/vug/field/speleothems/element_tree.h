// SPDX-License-Identifier: Apache-2.0
// The union of thousands of small solids: a tree of boxes finds the nearest ones of a point, so
// that an evaluation tests a few of them.
#pragma once

#include <vug/field/speleothems/element_list.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace vug::field {

/// E has: template <class T> T distance(const Point<T>&) const   (metres, Lipschitz constant 1)
///        Ball ball() const   (contains the solid; distance() is at least that to the ball)
template <class E>
class ElementTree {
 public:
  /// The two smallest distances and their elements; infinite if there are fewer elements, or if
  /// the second is not within `reach` of the first.
  struct Nearest {
    double first = kInfinity, second = kInfinity;
    const E* one = nullptr;
    const E* two = nullptr;
  };

  explicit ElementTree(std::vector<E> elements) : elements_(std::move(elements)) {
    if (!elements_.empty()) build(0, elements_.size());
  }
  const std::vector<E>& elements() const { return elements_; }
  Box3d bounds() const { return nodes_.empty() ? Box3d() : nodes_[0].box; }

  /// Appends the elements at most `limit` metres from p; false if there are more than `most`.
  bool within(const Vec3d& p, double limit, size_t most, std::vector<NearElement<E>>& out) const {
    std::array<uint32_t, 128> stack;
    size_t size = 0;
    if (!nodes_.empty()) stack[size++] = 0;
    while (size > 0) {
      const uint32_t self = stack[--size];
      const Branch& node = nodes_[self];
      if (least(node, p) > limit) continue;
      if (node.count == 0) {
        stack[size++] = node.at;
        stack[size++] = self + 1;
        continue;
      }
      for (uint32_t i = node.at; i < node.at + node.count; ++i) {
        const double distance = elements_[i].distance(point(p));
        if (!(distance <= limit)) continue;
        if (out.size() == most) return false;
        out.push_back({distance, &elements_[i]});
      }
    }
    return true;
  }

  /// Elements that are not nearer than `limit` are not found: it counts as their distance.
  Nearest nearest(const Vec3d& p, double reach, double limit = kInfinity) const {
    Nearest out{limit, limit};
    std::array<Visit, 128> stack;  // The depth is at most 64, since the tree is balanced.
    size_t size = 0;
    if (!nodes_.empty()) stack[size++] = {0, least(nodes_[0], p)};
    while (size > 0) {
      const Visit visit = stack[--size];
      if (visit.least >= std::min(out.second, out.first + reach)) continue;
      const Branch& node = nodes_[visit.node];
      if (node.count > 0) {
        for (uint32_t i = node.at; i < node.at + node.count; ++i) test(elements_[i], p, out);
        continue;
      }
      Visit near{visit.node + 1, least(nodes_[visit.node + 1], p)};
      Visit far{node.at, least(nodes_[node.at], p)};
      if (far.least < near.least) std::swap(near, far);
      stack[size++] = far;
      stack[size++] = near;
    }
    return out;
  }

  void add_to(Digester& digester) const { digester(elements_); }

 private:
  static constexpr size_t kLeaf = 4;
  struct Branch {
    Box3d box;
    double deepest = 0;  ///< The largest radius of a ball: no value inside is lower than its minus.
    uint32_t at = 0;     ///< The first element of a leaf, the second child of others.
    uint32_t count = 0;  ///< 0 unless it is a leaf.
  };
  struct Visit {
    uint32_t node = 0;
    double least = 0;
  };

  static double least(const Branch& node, const Vec3d& p) {
    const double squared = squared_distance(p, node.box);
    return squared > 0 ? std::sqrt(squared) : -node.deepest;
  }
  static void test(const E& element, const Vec3d& p, Nearest& out) {
    const Ball ball = element.ball();
    const double reach = out.second + ball.radius;
    if (reach < kInfinity && (p - ball.centre).length2() > square(std::max(reach, 0.0))) return;
    const double distance = element.distance(point(p));
    if (distance < out.first) {
      out.second = out.first;
      out.two = out.one;
      out.first = distance;
      out.one = &element;
    } else if (distance < out.second) {
      out.second = distance;
      out.two = &element;
    }
  }
  void build(size_t begin, size_t end) {
    const size_t self = nodes_.size();
    nodes_.emplace_back();
    Box3d box, middles;
    double deepest = 0;
    for (size_t i = begin; i < end; ++i) {
      const Ball ball = elements_[i].ball();
      box = united(box, grown(Box3d(ball.centre), ball.radius));
      middles.extendBy(ball.centre);
      deepest = std::max(deepest, ball.radius);
    }
    Branch branch{box, deepest, static_cast<uint32_t>(begin), static_cast<uint32_t>(end - begin)};
    if (end - begin > kLeaf) {
      const auto axis = static_cast<int>(middles.majorAxis());
      const size_t middle = begin + (end - begin) / 2;
      const auto at = [&](size_t i) { return elements_.begin() + static_cast<std::ptrdiff_t>(i); };
      std::nth_element(at(begin), at(middle), at(end), [axis](const E& a, const E& b) {
        return a.ball().centre[axis] < b.ball().centre[axis];
      });
      build(begin, middle);
      branch.count = 0;
      branch.at = static_cast<uint32_t>(nodes_.size());
      build(middle, end);
    }
    nodes_[self] = branch;
  }

  std::vector<E> elements_;
  std::vector<Branch> nodes_;
};

}  // namespace vug::field
