// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: a bounding volume hierarchy over the axes of passages.
#pragma once

#include <vug/passages/lines/axis_lines.h>
#include <vug/passages/nearest_first.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace vug::passages {

class LineBvh {
 public:
  struct Node {
    Box3d box;
    double low = kInfinity, high = -kInfinity;  // Heights of the floors below the node.
    uint32_t left = 0;              // Index of the left child, whose sibling follows; 0 for a leaf.
    uint32_t first = 0, count = 0;  // Of the lines of a leaf.
    double distance(const Vec3d& p) const { return std::sqrt(squared_distance(p, box)); }
  };

  /// The lines are reordered, so that those of a leaf follow one another. At least one.
  explicit LineBvh(std::vector<AxisLine> lines);

  const std::vector<AxisLine>& lines() const { return lines_; }
  Box3d bounds() const { return nodes_[0].box; }

  /// Calls visit(index, line) for all lines below nodes with bound(node) <= limit, nearer nodes
  /// first; `visit` may lower the limit.
  template <class Bound, class Visit>
  void search(const double& limit, const Bound& bound, const Visit& visit) const {
    visit_nearest_first(nodes_, limit, bound, [&](const Node& leaf) {
      for (uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) visit(i, lines_[i]);
    });
  }

  struct Nearest {
    double distance = kInfinity;
    Vec3d point{0.0};  ///< On a line.
  };
  /// The nearest point of the lines; if none is nearer than the limit, only the limit.
  Nearest nearest(const Vec3d& p, double limit = kInfinity) const;

  void add_to(Digester& digester) const { digester(lines_); }

 private:
  void build(uint32_t node, uint32_t first, uint32_t count);

  std::vector<AxisLine> lines_;
  std::vector<Node> nodes_;
};

}  // namespace vug::passages
