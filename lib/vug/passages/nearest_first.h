// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the traversal of bounding volume hierarchies from near to far.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace vug::passages {

/// Calls `visit(leaf)` for the leaves with bound(node) <= limit, nearer ones first; `visit` may
/// lower the limit. `bound(node)` is at most the bound of its children. A node has the index `left`
/// of its left child, whose sibling follows; 0 for a leaf. Nodes are halved, so the depth is at
/// most 64.
template <class Node, class Bound, class Visit>
void visit_nearest_first(const std::vector<Node>& nodes, const double& limit, const Bound& bound,
                         const Visit& visit) {
  constexpr size_t kStack = 128;
  std::pair<double, uint32_t> stack[kStack];
  size_t open = 0;
  stack[open++] = {bound(nodes[0]), 0};
  while (open > 0) {
    const auto [least, index] = stack[--open];
    if (least > limit) continue;
    const Node& node = nodes[index];
    if (node.left == 0) {
      visit(node);
      continue;
    }
    std::pair<double, uint32_t> near{bound(nodes[node.left]), node.left};
    std::pair<double, uint32_t> far{bound(nodes[node.left + 1]), node.left + 1};
    if (far.first < near.first) std::swap(near, far);
    stack[open++] = far;
    stack[open++] = near;
  }
}

}  // namespace vug::passages
