// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/water/fall.h>
#include <vug/passages/water/floor_plan.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kFreeFall = 9.81;
constexpr double kSheetStep = 0.2;  // Metres along the sheet.
constexpr double kIntoPool = 0.1;   // Metres by which the sheet enters the water below.
constexpr double kDeepest = 2;      // Metres below the foot to which the last piece leads at most.
constexpr int kMostSheetSteps = 8000;

/// The way by its distance in plan.
class Way {
 public:
  explicit Way(const std::vector<FallPoint>& points) : points_(points), along_(points.size(), 0) {
    for (size_t i = 1; i < points.size(); ++i) {
      const Vec3d step = in_plan(points[i].position - points[i - 1].position);
      along_[i] = along_[i - 1] + step.length();
    }
  }
  double length() const { return along_.back(); }
  /// The last point at or before x, with the height of the bed there; beyond the end, on the
  /// tangent.
  FallPoint at(double x) const {
    size_t i = 0;
    while (i + 2 < points_.size() && along_[i + 1] <= x) ++i;
    const FallPoint &a = points_[i], &b = points_[std::min(i + 1, points_.size() - 1)];
    const double length = along_[std::min(i + 1, points_.size() - 1)] - along_[i];
    FallPoint out = b;
    if (length > 1e-6) {
      const double t = std::max(0.0, (x - along_[i]) / length);
      out.position = a.position + (b.position - a.position) * t;
      if (t > 1) out.position.y = b.position.y;
    } else {
      out.position += Vec3d(0, 1, 0).cross(b.right) * (x - along_[i]);
    }
    return out;
  }

 private:
  const std::vector<FallPoint>& points_;
  std::vector<double> along_;
};

struct Sheet {
  Vec3d position{0.0};
  Vec3d right{1, 0, 0};
  double thickness = 0.1;
};

/// The piece of the sheet between two of its points.
void append_piece(const Sheet& a, const Sheet& b, double width, std::vector<Polytope>& out) {
  const Vec3d along = (b.position - a.position).normalized();
  const Vec3d right = (a.right + b.right).normalized();
  const Vec3d up = right.cross(along).normalized() * -1;
  const Vec3d front = up.y > 0 || (up.y == 0 && along.y < 0) ? up : -up;
  const double thickness = std::max(a.thickness, b.thickness), half = 0.5 * width;
  const double seam = std::max(0.5 * thickness, 0.05);
  Polytope part;
  const auto face = [&](const Vec3d& normal, const Vec3d& point, double beyond) {
    part.faces.push_back({normal, normal.dot(point) + beyond});
  };
  face(front, a.position, 0);
  face(-front, a.position, thickness);
  face(right, a.position, half);
  face(-right, a.position, half);
  face(along, b.position, seam);
  face(-along, a.position, seam);
  for (const Sheet* end : {&a, &b})
    for (const double side : {-half, half})
      for (const double depth : {0.0, thickness})
        for (const double beyond : {-seam, seam})
          part.box.extendBy(end->position + right * side - front * depth + along * beyond);
  out.push_back(std::move(part));
}

}  // namespace

void append_fall(const Fall& fall, std::vector<Polytope>& out) {
  if (fall.way.size() < 2 || !(fall.width > 0) || !(fall.discharge > 0)) return;
  const Way way(fall.way);
  const double per_width = fall.discharge / fall.width;
  const double critical = maths::pow(per_width * per_width / kFreeFall, 1.0 / 3);
  const double speed = std::sqrt(kFreeFall * critical);
  const double lip = fall.way.front().position.y;
  Sheet before{fall.way.front().position, fall.way.front().right,
               std::max(critical, fall.thickness)};
  // On a long bed, steps of the parabola would become too short to reach its end.
  const double least_step = 2 * way.length() / kMostSheetSteps;
  double x = 0;
  for (int step = 0; step < kMostSheetSteps && before.position.y > fall.foot - kIntoPool; ++step) {
    // Steps have equal lengths along the parabola, or along the bed.
    const double steepness = kFreeFall * x / (speed * speed);
    x += std::max(kSheetStep / std::sqrt(1 + steepness * steepness), least_step);
    const double free = lip - kFreeFall * x * x / (2 * speed * speed);
    FallPoint next = way.at(x);
    // Past the end of the way, only the parabola remains. After a slide it is far below the bed.
    next.position.y = x < way.length() ? std::max(free, next.position.y) : free;
    next.position.y = std::max(next.position.y, fall.foot - kDeepest);
    next.position.y = std::min(next.position.y, before.position.y);
    const double drop = std::max(0.0, lip - next.position.y);
    const double fast = std::sqrt(speed * speed + 2 * kFreeFall * drop);
    const Sheet after{next.position, next.right, std::max(per_width / fast, fall.thickness)};
    append_piece(before, after, fall.width, out);
    before = after;
  }
}

}  // namespace vug::passages
