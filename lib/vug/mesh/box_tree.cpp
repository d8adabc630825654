// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/box_tree.h>

#include <algorithm>
#include <numeric>

namespace vug::mesh {
namespace {
constexpr uint32_t kLeafItems = 4;
}

BoxTree::BoxTree(const std::vector<Box3d>& boxes) : items_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), 0U);
  nodes_.reserve(boxes.size());
  nodes_.push_back({{}, 0, static_cast<uint32_t>(boxes.size())});
  // Level by level: the nodes of a level have separate items, and their children follow in order.
  for (size_t begin = 0; begin < nodes_.size();) {
    const size_t end = nodes_.size();
    parallel_for(end - begin, [&](size_t i) { arrange(nodes_[begin + i], boxes); });
    for (; begin < end; ++begin) add_children(nodes_[begin]);
  }
}

void BoxTree::arrange(Node& node, const std::vector<Box3d>& boxes) {
  Box3d centres;
  for (uint32_t i = node.first; i < node.first + node.count; ++i) {
    node.box.extendBy(boxes[items_[i]]);
    centres.extendBy(boxes[items_[i]].center());
  }
  if (node.count <= kLeafItems) return;
  const auto axis = static_cast<int>(centres.majorAxis());
  const auto begin = items_.begin() + node.first;
  std::nth_element(begin, begin + node.count / 2, begin + node.count, [&](uint32_t a, uint32_t b) {
    const double at_a = boxes[a].min[axis] + boxes[a].max[axis];
    const double at_b = boxes[b].min[axis] + boxes[b].max[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  });
}

void BoxTree::add_children(Node& node) {
  if (node.count <= kLeafItems) return;
  const uint32_t first = node.first, count = node.count, half = count / 2;
  node.first = static_cast<uint32_t>(nodes_.size());
  node.count = 0;
  nodes_.push_back({{}, first, half});
  nodes_.push_back({{}, first + half, count - half});
}

}  // namespace vug::mesh
