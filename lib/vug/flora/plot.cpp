#include <vug/base/error.h>
#include <vug/flora/plot.h>
#include <vug/mesh/polygon.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

constexpr double kFarthest = 1e6;
constexpr size_t kMostCorners = 20000;  // every side is held against every other

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

CGAL::Orientation turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y),
                           Kernel::Point_2(c.x, c.y));
}

/// Of a point in line with a and b.
bool lies_between(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool meet(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  const auto abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc != abd && cda != cdb) return true;
  return (abc == CGAL::COLLINEAR && lies_between(a, b, c)) ||
         (abd == CGAL::COLLINEAR && lies_between(a, b, d)) ||
         (cda == CGAL::COLLINEAR && lies_between(c, d, a)) ||
         (cdb == CGAL::COLLINEAR && lies_between(c, d, b));
}

Vec2d crossing(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  const Vec2d ab = b - a, cd = d - c;
  const double across = ab.cross(cd);
  return across != 0 ? a + ab * ((c - a).cross(cd) / across) : c;
}

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::bad_input, what); }

void require_numbers(const Corners& corners) {
  if (corners.size() < 3)
    refuse(fmt::format("a polygon has 3 corners at least, not {}", corners.size()));
  if (corners.size() > kMostCorners)
    refuse(fmt::format("a polygon of {} corners; {} are the most", corners.size(), kMostCorners));
  for (size_t i = 0; i < corners.size(); ++i)
    if (!(std::fabs(corners[i].x) <= kFarthest && std::fabs(corners[i].y) <= kFarthest))
      refuse(fmt::format("corner {} of the polygon is at {}; numbers are 1e6 m at most", i + 1,
                         to_string(corners[i])));
}

/// Sides are counted from 1, each from the corner of its number to the next.
void require_simple(const Corners& corners) {
  const size_t n = corners.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2d &a = corners[i], &b = corners[(i + 1) % n], &c = corners[(i + 2) % n];
    if (a == b)
      refuse(fmt::format("corners {} and {} of the polygon are both at {}", i + 1, (i + 1) % n + 1,
                         to_string(a)));
    if (turn(a, b, c) == CGAL::COLLINEAR && (b - a).dot(c - b) < 0)
      refuse(fmt::format("side {} of the polygon runs back along side {}, from {}", (i + 1) % n + 1,
                         i + 1, to_string(b)));
  }
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      const Vec2d &a = corners[i], &b = corners[(i + 1) % n];
      const Vec2d &d = corners[j], &e = corners[(j + 1) % n];
      if (meet(a, b, d, e))
        refuse(fmt::format("sides {} and {} of the polygon cross or touch at {}", i + 1, j + 1,
                           to_string(crossing(a, b, d, e))));
    }
}

/// Corners are told apart in single precision there; here only their numbers are taken.
std::vector<mesh::Triangle> triangles_of(const Corners& corners, const Vec2d& low,
                                         const Vec2d& high) {
  mesh::Mesh plane;
  std::vector<uint32_t> ring;
  const Vec2d middle = (low + high) / 2;
  for (const Vec2d& corner : corners) {
    ring.push_back(static_cast<uint32_t>(ring.size()));
    const Vec2d at = corner - middle;
    plane.positions.emplace_back(static_cast<float>(at.x), static_cast<float>(at.y), 0.0f);
  }
  mesh::add_rings(plane, {ring});
  return plane.triangles;
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
  triangles_ = triangles_of(corners_, low_, high_);
  double sum = 0;
  for (const auto& [a, b, c] : triangles_) {
    sum += std::fabs((corners_[b] - corners_[a]).cross(corners_[c] - corners_[a])) / 2;
    total_.push_back(sum);
  }
  if (!(sum > 0)) refuse("a polygon without an area");
}

bool Plot::contains(const Vec2d& p) const {
  bool inside = false;
  for (size_t i = 0, before = corners_.size() - 1; i < corners_.size(); before = i++) {
    const Vec2d &a = corners_[before], &b = corners_[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const auto side = a.y < b.y ? turn(a, b, p) : turn(b, a, p);
    if (side == CGAL::LEFT_TURN) inside = !inside;
  }
  return inside;
}

double Plot::to_border(const Vec2d& p) const {
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

int Plot::dent() const {
  double turned = 0;  // twice the signed area
  const size_t n = corners_.size();
  for (size_t i = 0; i < n; ++i)
    turned += (corners_[i] - corners_[0]).cross(corners_[(i + 1) % n] - corners_[0]);
  const auto wrong = turned > 0 ? CGAL::RIGHT_TURN : CGAL::LEFT_TURN;
  for (size_t i = 0; i < n; ++i)
    if (turn(corners_[(i + n - 1) % n], corners_[i], corners_[(i + 1) % n]) == wrong)
      return static_cast<int>(i);
  return -1;
}

}  // namespace vug::flora
