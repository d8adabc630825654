// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/nearest_first.h>
#include <vug/passages/sweep/segment_bvh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vug::passages {
namespace {

constexpr uint32_t kLeafSize = 4;
constexpr size_t kStack = 128;

}  // namespace

SegmentBvh::SegmentBvh(const std::vector<Segment>& segments, const std::vector<Capsule>& capsules)
    : segments_(segments), capsules_(capsules), order_(segments.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(2 * segments.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<uint32_t>(segments.size()));
}

void SegmentBvh::build(uint32_t at, uint32_t first, uint32_t count) {
  Node node;
  Box3d centres;
  for (uint32_t i = first; i < first + count; ++i) {
    const Segment& segment = segments_[order_[i]];
    node.box.extendBy(segment.start());
    node.box.extendBy(segment.end());
    centres.extendBy(0.5 * (segment.start() + segment.end()));
    node.reach = std::max(node.reach, segment.reach());
    node.scale = std::min(node.scale, segment.scale());
  }
  node.first = first;
  node.count = count;
  if (count > kLeafSize) {
    const auto axis = static_cast<int>(centres.majorAxis());
    const uint32_t half = count / 2;
    const auto key = [&](uint32_t i) {
      return std::pair(segments_[i].start()[axis] + segments_[i].end()[axis], i);
    };
    std::nth_element(order_.begin() + first, order_.begin() + first + half,
                     order_.begin() + first + count,
                     [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    node.left = static_cast<uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    build(node.left, first, half);
    build(node.left + 1, first + half, count - half);
  }
  nodes_[at] = node;
}

double SegmentBvh::Node::least(const Vec3d& p) const {
  const double away = std::sqrt(squared_distance(p, box)) - reach;
  return away > 0 ? scale * away : away;
}

SegmentBvh::Nearest SegmentBvh::nearest(const Vec3d& p) const {
  Nearest best;
  visit_nearest_first(
      nodes_, best.value, [&](const Node& node) { return node.least(p); },
      [&](const Node& leaf) {
        for (uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
          if (capsules_[order_[i]].least(p) >= best.value) continue;
          const Segment& segment = segments_[order_[i]];
          if (segment.least(p) > best.value + segment.rounding(p)) continue;
          const double value = segment.value(field::point(p));
          if (value < best.value) best = {value, order_[i]};
        }
      });
  return best;
}

bool SegmentBvh::collect(const Vec3d& p, double limit, size_t most,
                         std::vector<uint32_t>& out) const {
  uint32_t stack[kStack];
  size_t open = 0;
  const size_t before = out.size();
  if (nodes_[0].least(p) <= limit) stack[open++] = 0;
  while (open > 0) {
    const Node& node = nodes_[stack[--open]];
    if (node.left != 0) {
      for (const uint32_t child : {node.left, node.left + 1})
        if (nodes_[child].least(p) <= limit) stack[open++] = child;
      continue;
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (capsules_[order_[i]].least(p) > limit) continue;
      if (out.size() - before == most) return false;
      out.push_back(order_[i]);
    }
  }
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(before), out.end());
  return true;
}

}  // namespace vug::passages
