#include <vug/flora/crossing.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

constexpr size_t kMostPairs = 200'000'000;
constexpr double kWithin = 1e-9;  // of a side's length, from its ends
constexpr double kApart = 1e-6;   // of the polygon's size: sides so far apart pass over each other

/// Newell's normal, or where the lobes of an outline cancel out that of its largest corner.
Vec3d normal_of(const std::vector<Vec3d>& corners) {
  Vec3d sum(0), largest(0);
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3d part = (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    sum += part;
    if (part.length() > largest.length()) largest = part;
  }
  return sum.length() > 1e-6 * largest.length() ? sum : largest;
}

/// A polygon seen along the axis that is nearest to its normal.
class Outline {
 public:
  explicit Outline(const std::vector<Vec3d>& corners) : corners_(corners) {
    const Vec3d normal = normal_of(corners);
    int drop = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (std::fabs(normal[axis]) > std::fabs(normal[drop])) drop = axis;
    x_ = (drop + 1) % 3;
    y_ = (drop + 2) % 3;
    Vec3d low = corners[0], high = corners[0];
    for (const Vec3d& corner : corners)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], corner[axis]);
        high[axis] = std::max(high[axis], corner[axis]);
      }
    size_ = (high - low).length();
  }

  size_t size() const { return corners_.size(); }
  double low(size_t side) const { return std::min(begin(side)[x_], end(side)[x_]); }
  double high(size_t side) const { return std::max(begin(side)[x_], end(side)[x_]); }

  /// Where two sides go through each other; nothing for neighbours.
  std::optional<Vec3d> crossing(size_t i, size_t j) const {
    if ((i + 1) % size() == j || (j + 1) % size() == i) return std::nullopt;
    const Vec3d &a = begin(i), &c = begin(j);
    const Vec3d ab = end(i) - a, cd = end(j) - c, ac = c - a;
    const double across = turned(ab, cd);
    if (across == 0) return std::nullopt;
    const double t = turned(ac, cd) / across, u = turned(ac, ab) / across;
    const auto within = [](double at) { return at > kWithin && at < 1 - kWithin; };
    if (!within(t) || !within(u)) return std::nullopt;
    const Vec3d at = a + ab * t;
    if (!((at - (c + cd * u)).length() <= kApart * size_)) return std::nullopt;
    return at;
  }

 private:
  const Vec3d& begin(size_t side) const { return corners_[side]; }
  const Vec3d& end(size_t side) const { return corners_[(side + 1) % corners_.size()]; }
  double turned(const Vec3d& v, const Vec3d& w) const { return v[x_] * w[y_] - v[y_] * w[x_]; }

  const std::vector<Vec3d>& corners_;
  int x_, y_;
  double size_;
};

}  // namespace

std::optional<Crossing> self_crossing(const std::vector<Vec3d>& corners) {
  if (corners.size() < 4) return std::nullopt;
  const Outline outline(corners);
  std::vector<size_t> order(outline.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t i, size_t j) { return outline.low(i) < outline.low(j); });
  size_t pairs = 0;
  for (size_t k = 0; k < order.size(); ++k)
    for (size_t l = k + 1; l < order.size(); ++l) {
      if (outline.low(order[l]) > outline.high(order[k])) break;
      if (++pairs > kMostPairs) return std::nullopt;
      if (const auto at = outline.crossing(order[k], order[l]))
        return Crossing{std::min(order[k], order[l]) + 1, std::max(order[k], order[l]) + 1, *at};
    }
  return std::nullopt;
}

}  // namespace vug::flora
