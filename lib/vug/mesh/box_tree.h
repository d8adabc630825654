// SPDX-License-Identifier: Apache-2.0
// A binary bounding volume hierarchy over numbered items such as triangles, with nearest-first
// traversal and overlap queries. Nodes are split at the median centre along the widest axis, so the
// tree is the same for any number of threads.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::mesh {

class BoxTree {
 public:
  struct Node {
    Box3d box;
    uint32_t first = 0;  ///< Leaf: index of its first item. Inner node: left child; the right child
                         ///< is first + 1.
    uint32_t count = 0;  ///< 0 for inner nodes.
  };

  BoxTree() = default;
  explicit BoxTree(const std::vector<Box3d>& boxes);

  bool empty() const { return nodes_.empty(); }
  const Box3d& bounds() const { return nodes_.front().box; }

  /// Calls `visit(item)` for the items whose box is within the limit of p, near boxes first.
  /// `visit` returns the new squared limit.
  template <class Visit>
  void visit_nearest(const Vec3d& p, double squared_limit, const Visit& visit) const;

  /// Calls `visit(item)` for each item whose box touches `box`.
  template <class Visit>
  void visit_overlapping(const Box3d& box, const Visit& visit) const;

 private:
  /// Computes the box of a node, and orders its items by the half that they belong to.
  void arrange(Node& node, const std::vector<Box3d>& boxes);
  void add_children(Node& node);

  std::vector<Node> nodes_;
  std::vector<uint32_t> items_;
};

template <class Visit>
void BoxTree::visit_nearest(const Vec3d& p, double squared_limit, const Visit& visit) const {
  struct Entry {
    uint32_t node;
    double distance;
  };
  // Median splits limit the depth to 2 + log2 of 2^32 items, and each level leaves one sibling on
  // the stack.
  std::array<Entry, 64> stack;
  size_t size = 0;
  if (!nodes_.empty()) stack[size++] = {0, squared_distance(p, nodes_[0].box)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.distance > squared_limit) continue;
    const Node& node = nodes_[entry.node];
    for (uint32_t i = 0; i < node.count; ++i) squared_limit = visit(items_[node.first + i]);
    if (node.count > 0) continue;
    const double left = squared_distance(p, nodes_[node.first].box);
    const double right = squared_distance(p, nodes_[node.first + 1].box);
    const bool left_is_near = left <= right;
    stack[size++] = left_is_near ? Entry{node.first + 1, right} : Entry{node.first, left};
    stack[size++] = left_is_near ? Entry{node.first, left} : Entry{node.first + 1, right};
  }
}

template <class Visit>
void BoxTree::visit_overlapping(const Box3d& box, const Visit& visit) const {
  std::array<uint32_t, 64> stack;  // NOLINT: filled as it grows
  size_t size = 0;
  if (!nodes_.empty()) stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (!node.box.intersects(box)) continue;
    for (uint32_t i = 0; i < node.count; ++i) visit(items_[node.first + i]);
    if (node.count > 0) continue;
    stack[size++] = node.first + 1;
    stack[size++] = node.first;
  }
}

}  // namespace vug::mesh
