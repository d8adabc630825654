// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/orientation.h>
#include <vug/flora/self_intersection.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

constexpr size_t kMaxPairs = 200'000'000;
constexpr double kWithin = 1e-9;  // Relative to a side's length, from its ends.
// Relative to the polygon's size; sides further apart pass over each other.
constexpr double kApart = 1e-6;

/// Newell's normal, or the normal of the largest triangle if the lobes of an outline cancel out.
Vec3d normal_of(const std::vector<Vec3d>& corners) {
  Vec3d sum(0), largest(0);
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3d part = (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    sum += part;
    if (part.length() > largest.length()) largest = part;
  }
  return sum.length() > 1e-6 * largest.length() ? sum : largest;
}

/// For a point collinear with a and b.
bool lies_between(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

struct Side {
  size_t number;
  Vec2d from, to;  ///< In the projection.
  double low, high;
};

enum class Meeting { none, touch, cross };

Meeting meeting(const Side& s, const Side& t) {
  const Vec2d &a = s.from, &b = s.to, &c = t.from, &d = t.to;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return Meeting::none;
  const int abc = orientation(a, b, c), abd = orientation(a, b, d), cda = orientation(c, d, a),
            cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return Meeting::cross;
  const bool touch = (abc == 0 && lies_between(a, b, c)) || (abd == 0 && lies_between(a, b, d)) ||
                     (cda == 0 && lies_between(c, d, a)) || (cdb == 0 && lies_between(c, d, b));
  return touch ? Meeting::touch : Meeting::none;
}

/// A polygon projected along the axis nearest to its normal.
class Outline {
 public:
  explicit Outline(const std::vector<Vec3d>& corners) : corners_(corners) {
    Vec3d low = corners[0], high = corners[0];
    for (const Vec3d& corner : corners)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], corner[axis]);
        high[axis] = std::max(high[axis], corner[axis]);
      }
    size_ = (high - low).length();
    const Vec3d normal = normal_of(corners), along = high - low;
    // A collinear outline has no normal; use the axis of its smallest extent.
    int drop = 2;
    for (int axis = 0; axis < 2; ++axis) {
      const double more = std::fabs(normal[axis]) - std::fabs(normal[drop]);
      if (more > 0 || (more == 0 && along[axis] < along[drop])) drop = axis;
    }
    for (size_t i = 0; i < corners.size(); ++i) {
      const Vec2d from = projected(corners[i], drop), to = projected(end(i), drop);
      sides_.push_back({i, from, to, std::min(from.x, to.x), std::max(from.x, to.x)});
    }
    std::stable_sort(sides_.begin(), sides_.end(),
                     [](const Side& s, const Side& t) { return s.low < t.low; });
  }

  /// Sorted by their minimum x.
  const std::vector<Side>& sides() const { return sides_; }

  /// Intersection of two sides; empty for adjacent sides.
  std::optional<Vec3d> crossing(const Side& s, const Side& t, Touching touching) const {
    const size_t n = corners_.size();
    if ((s.number + 1) % n == t.number || (t.number + 1) % n == s.number) return std::nullopt;
    const Meeting how = meeting(s, t);
    if (how == Meeting::none || (how == Meeting::touch && touching == Touching::allowed))
      return std::nullopt;
    const Vec2d ab = s.to - s.from, cd = t.to - t.from, ac = t.from - s.from;
    const double across = ab.cross(cd);
    if (across == 0) return along(s, t);
    const double at = ac.cross(cd) / across, other = ac.cross(ab) / across;
    const auto within = [](double share) { return share > kWithin && share < 1 - kWithin; };
    if (touching == Touching::allowed && !(within(at) && within(other))) return std::nullopt;
    const Vec3d here = on(s, at);
    if (!((here - on(t, other)).length() <= kApart * size_)) return std::nullopt;
    return here;
  }

 private:
  static Vec2d projected(const Vec3d& p, int drop) {
    return {p[(drop + 1) % 3], p[(drop + 2) % 3]};
  }
  const Vec3d& end(size_t side) const { return corners_[(side + 1) % corners_.size()]; }
  Vec3d on(const Side& side, double share) const {
    const Vec3d& from = corners_[side.number];
    return from + (end(side.number) - from) * share;
  }
  /// A corner of one collinear side that lies on the other.
  Vec3d along(const Side& s, const Side& t) const {
    return lies_between(s.from, s.to, t.from) ? corners_[t.number]
           : lies_between(s.from, s.to, t.to) ? end(t.number)
                                              : corners_[s.number];
  }

  const std::vector<Vec3d>& corners_;
  std::vector<Side> sides_;
  double size_;
};

}  // namespace

std::optional<SelfIntersection> find_self_intersection(const std::vector<Vec3d>& corners,
                                                       Touching touching) {
  if (corners.size() < 4) return std::nullopt;
  const Outline outline(corners);
  const std::vector<Side>& sides = outline.sides();
  size_t pairs = 0;
  for (size_t i = 0; i < sides.size(); ++i)
    for (size_t j = i + 1; j < sides.size() && sides[j].low <= sides[i].high; ++j) {
      if (++pairs > kMaxPairs) return std::nullopt;
      if (const auto at = outline.crossing(sides[i], sides[j], touching)) {
        const auto [first, second] = std::minmax(sides[i].number, sides[j].number);
        return SelfIntersection{first + 1, second + 1, *at};
      }
    }
  return std::nullopt;
}

}  // namespace vug::flora
