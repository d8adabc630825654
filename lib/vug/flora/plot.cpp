// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/flora/orientation.h>
#include <vug/flora/plot.h>
#include <vug/flora/self_intersection.h>
#include <vug/mesh/polygon.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

constexpr double kFarthest = 1e6;
constexpr double kInLine = 1e-9;       // Radians of rounding error allowed for collinear sides.
constexpr size_t kMaxCorners = 20000;  // Every side may be tested against every other.

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::bad_input, what); }

void require_numbers(const Corners& corners) {
  if (corners.size() < 3)
    refuse(fmt::format("a polygon needs at least 3 corners, not {}", corners.size()));
  if (corners.size() > kMaxCorners)
    refuse(fmt::format("a polygon of {} corners; the limit is {}", corners.size(), kMaxCorners));
  for (size_t i = 0; i < corners.size(); ++i)
    if (!(std::fabs(corners[i].x) <= kFarthest && std::fabs(corners[i].y) <= kFarthest))
      refuse(fmt::format("corner {} of the polygon is at {}; coordinates must be at most 1e6 m",
                         i + 1, to_string(corners[i])));
}

/// Sides count from 1; each leads from the corner of its number to the next.
void require_simple(const Corners& corners) {
  const size_t n = corners.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2d &a = corners[i], &b = corners[(i + 1) % n], &c = corners[(i + 2) % n];
    if (a == b)
      refuse(fmt::format("corners {} and {} of the polygon are both at {}", i + 1, (i + 1) % n + 1,
                         to_string(a)));
    if (orientation(a, b, c) == 0 && (b - a).dot(c - b) < 0)
      refuse(fmt::format("side {} of the polygon runs back along side {}, from {}", (i + 1) % n + 1,
                         i + 1, to_string(b)));
  }
  std::vector<Vec3d> level;
  for (const Vec2d& p : corners) level.emplace_back(p.x, p.y, 0);
  if (const auto fault = find_self_intersection(level, Touching::refused))
    refuse(fmt::format("sides {} and {} of the polygon cross or touch at {}", fault->first,
                       fault->second, to_string(Vec2d(fault->at.x, fault->at.y))));
}

}  // namespace

std::string to_string(const Vec2d& point) {
  return fmt::format("({:.6g}, {:.6g})", point.x, point.y);
}

Plot::Plot(Corners corners) : corners_(std::move(corners)) {
  require_numbers(corners_);
  require_simple(corners_);
  low_ = high_ = corners_[0];
  for (const Vec2d& p : corners_) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  triangles_ = mesh::triangles_of({corners_});
  double sum = 0;
  for (const auto& [a, b, c] : triangles_) {
    sum += std::fabs((corners_[b] - corners_[a]).cross(corners_[c] - corners_[a])) / 2;
    total_.push_back(sum);
  }
  if (!(sum > 0)) refuse("the polygon has no area");
}

bool Plot::contains(const Vec2d& p) const {
  bool inside = false;
  for (size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
    const Vec2d &a = corners_[before], &b = corners_[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const int side = a.y < b.y ? orientation(a, b, p) : orientation(b, a, p);
    if (side > 0) inside = !inside;
  }
  return inside;
}

double Plot::border_distance(const Vec2d& p) const {
  double nearest = kInfinity;
  for (size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
    const Vec2d a = corners_[before], ab = corners_[i] - a;
    const double along = std::clamp((p - a).dot(ab) / ab.length2(), 0.0, 1.0);
    nearest = std::min(nearest, (a + ab * along - p).length2());
  }
  return std::sqrt(nearest);
}

Vec2d Plot::point(RandomStream& random) const {
  const double at = random.uniform() * area();
  const auto found = std::upper_bound(total_.begin(), total_.end(), at) - total_.begin();
  const auto last = static_cast<std::ptrdiff_t>(triangles_.size()) - 1;
  const auto& [a, b, c] = triangles_[static_cast<size_t>(std::min(found, last))];
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return corners_[a] + (corners_[b] - corners_[a]) * u + (corners_[c] - corners_[a]) * v;
}

int Plot::first_reflex_corner() const {
  double turned = 0;  // Twice the signed area.
  const size_t n = corners_.size();
  for (size_t i = 0; i < n; ++i)
    turned += (corners_[i] - corners_[0]).cross(corners_[(i + 1) % n] - corners_[0]);
  for (size_t i = 0; i < n; ++i) {
    const Vec2d &a = corners_[(i + n - 1) % n], &b = corners_[i], &c = corners_[(i + 1) % n];
    const double inwards = (c - b).cross(b - a) * (turned > 0 ? 1 : -1);
    if (inwards > kInLine * (b - a).length() * (c - b).length()) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace vug::flora
