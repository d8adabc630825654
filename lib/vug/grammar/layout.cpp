// SPDX-License-Identifier: Apache-2.0
#include <vug/grammar/layout.h>

#include <algorithm>

namespace vug::grammar {
namespace {

/// The contour of one side of a subtree: the extreme coordinate at each level minus `shift`,
/// deepest level first.
struct Side {
  std::vector<double> levels;
  double shift = 0;

  size_t depth() const { return levels.size(); }
  double at(size_t level) const { return levels[levels.size() - 1 - level] + shift; }
  void set(size_t level, double value) { levels[levels.size() - 1 - level] = value - shift; }
  void push_root(double value) { levels.push_back(value - shift); }
};

/// Merges two contours: `upper` at its levels, below them `other`. Costs the depth of the shallower
/// one.
Side overlaid(Side upper, Side other) {
  if (upper.depth() >= other.depth()) return upper;
  for (size_t level = 0; level < upper.depth(); ++level) other.set(level, upper.at(level));
  return other;
}

struct Contour {
  Side low, high;
};

/// The shift by which `next` must move to keep its distance from `placed`.
double clearance(const Contour& placed, const Contour& next) {
  const size_t levels = std::min(placed.high.depth(), next.low.depth());
  double shift = -1e300;
  for (size_t level = 0; level < levels; ++level)
    shift = std::max(shift, placed.high.at(level) + 1 - next.low.at(level));
  return shift;
}

}  // namespace

std::vector<double> tidy_layout(const Tree& tree) {
  const size_t count = tree.nodes.size();
  std::vector<double> place(count, 0);  // relative to the parent, finally absolute
  std::vector<Contour> contours(count);
  for (size_t i = count; i-- > 0;) {  // children come after their parents
    const auto& children = tree.nodes[i].children;
    Contour joined;
    for (const int c : children) {
      const auto child = static_cast<size_t>(c);
      Contour next = std::move(contours[child]);
      if (c == children.front()) {
        joined = std::move(next);
        continue;
      }
      const double shift = clearance(joined, next);
      place[child] = shift;
      next.low.shift += shift;
      next.high.shift += shift;
      joined.low = overlaid(std::move(joined.low), std::move(next.low));
      joined.high = overlaid(std::move(next.high), std::move(joined.high));
    }
    if (!children.empty()) {
      const double middle = 0.5 * place[static_cast<size_t>(children.back())];
      for (const int c : children) place[static_cast<size_t>(c)] -= middle;
      joined.low.shift -= middle;
      joined.high.shift -= middle;
    }
    joined.low.push_root(0);
    joined.high.push_root(0);
    contours[i] = std::move(joined);
  }
  if (count == 0) return place;
  double lowest = 0;
  for (size_t level = 0; level < contours[0].low.depth(); ++level)
    lowest = std::min(lowest, contours[0].low.at(level));
  place[0] = -lowest;
  for (size_t i = 1; i < count; ++i) place[i] += place[static_cast<size_t>(tree.nodes[i].parent)];
  return place;
}

}  // namespace vug::grammar
