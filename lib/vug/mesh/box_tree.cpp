// SPDX-License-Identifier: Apache-2.0
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
  // Children follow their parents, so the list of nodes serves as work list.
  for (uint32_t node = 0; node < nodes_.size(); ++node) split(node, boxes);
}

void BoxTree::split(uint32_t index, const std::vector<Box3d>& boxes) {
  const uint32_t first = nodes_[index].first;
  const uint32_t count = nodes_[index].count;
  Box3d around;
  Box3d centres;
  for (uint32_t i = first; i < first + count; ++i) {
    around.extendBy(boxes[items_[i]]);
    centres.extendBy(boxes[items_[i]].center());
  }
  nodes_[index].box = around;
  if (count <= kLeafItems) return;
  const auto axis = static_cast<int>(centres.majorAxis());
  const auto begin = items_.begin() + first;
  const uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](uint32_t a, uint32_t b) {
    const double at_a = boxes[a].min[axis] + boxes[a].max[axis];
    const double at_b = boxes[b].min[axis] + boxes[b].max[axis];
    return at_a != at_b ? at_a < at_b : a < b;
  });
  const auto left = static_cast<uint32_t>(nodes_.size());
  nodes_[index].first = left;
  nodes_[index].count = 0;
  nodes_.push_back({{}, first, half});
  nodes_.push_back({{}, first + half, count - half});
}

}  // namespace vug::mesh
