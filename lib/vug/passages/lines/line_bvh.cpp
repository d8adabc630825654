// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/lines/line_bvh.h>

#include <algorithm>

namespace vug::passages {
namespace {

constexpr uint32_t kLinesPerLeaf = 4;

Vec3d nearest_point(const AxisLine& line, const Vec3d& p) {
  const Vec3d along = line.vector();
  return line.from + along * std::clamp((p - line.from).dot(along) / along.length2(), 0.0, 1.0);
}

}  // namespace

LineBvh::LineBvh(std::vector<AxisLine> lines) : lines_(std::move(lines)) {
  nodes_.reserve(2 * lines_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<uint32_t>(lines_.size()));
}

void LineBvh::build(uint32_t at, uint32_t first, uint32_t count) {
  Node node;
  node.first = first;
  node.count = count;
  const auto begin = lines_.begin() + first;
  std::for_each(begin, begin + count, [&](const AxisLine& line) {
    node.box.extendBy(line.from);
    node.box.extendBy(line.to);
    node.low = std::min({node.low, line.floor_from, line.floor_to});
    node.high = std::max({node.high, line.floor_from, line.floor_to});
  });
  if (count > kLinesPerLeaf) {
    const auto axis = static_cast<int>(node.box.majorAxis());
    const uint32_t half = count / 2;
    std::stable_sort(begin, begin + count, [axis](const AxisLine& a, const AxisLine& b) {
      return a.from[axis] + a.to[axis] < b.from[axis] + b.to[axis];
    });
    node.left = static_cast<uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    build(node.left, first, half);
    build(node.left + 1, first + half, count - half);
  }
  nodes_[at] = node;
}

LineBvh::Nearest LineBvh::nearest(const Vec3d& p, double limit) const {
  Nearest best{limit, Vec3d(0.0)};
  search(
      best.distance, [&](const Node& node) { return node.distance(p); },
      [&](uint32_t, const AxisLine& line) {
        const Vec3d point = nearest_point(line, p);
        const double distance = (p - point).length();
        if (distance < best.distance) best = {distance, point};
      });
  return best;
}

}  // namespace vug::passages
