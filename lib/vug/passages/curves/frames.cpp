// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/curves/frames.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kLevel = 0.766044443118978;  // sin 50 degrees
constexpr double kSteep = 0.939692620785908;  // sin 70 degrees

/// 1 for level tangents, 0 for steep ones.
double gravity_weight(const Vec3d& tangent) {
  const double t = std::clamp((std::fabs(tangent.y) - kLevel) / (kSteep - kLevel), 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

Vec3d perpendicular(const Vec3d& v, const Vec3d& tangent) {
  return (v - tangent * v.dot(tangent)).normalized();
}

/// `right` from one point to another without rotation about the curve, by two reflections.
Vec3d transported(const Vec3d& right, const Vec3d& step, const Vec3d& from, const Vec3d& to) {
  const double length2 = step.length2();
  if (length2 <= 0) return perpendicular(right, to);
  const Vec3d r = right - step * (2 * step.dot(right) / length2);
  const Vec3d t = from - step * (2 * step.dot(from) / length2);
  const Vec3d axis = to - t;
  const double axis2 = axis.length2();
  const Vec3d turned = axis2 > 1e-30 ? r - axis * (2 * axis.dot(r) / axis2) : r;
  return perpendicular(turned, to);
}

/// The transported direction, turned towards the horizontal one by the weight of gravity.
Vec3d upright(const Vec3d& right, const Vec3d& tangent) {
  const double weight = gravity_weight(tangent);
  if (weight <= 0) return right;
  const Vec3d level = tangent.cross(Vec3d(0, 1, 0)).normalized();
  if (weight >= 1) return level;
  const double angle = weight * maths::atan2(tangent.dot(right.cross(level)), right.dot(level));
  return perpendicular(right * maths::cos(angle) + tangent.cross(right) * maths::sin(angle),
                       tangent);
}

}  // namespace

std::vector<Frame> frames(const std::vector<Vec3d>& points, const std::vector<Vec3d>& tangents) {
  const size_t n = points.size();
  std::vector<Frame> out(n);
  // Start where the tangent is least steep, and continue to both ends.
  size_t start = 0;
  for (size_t i = 1; i < n; ++i)
    if (std::fabs(tangents[i].y) < std::fabs(tangents[start].y) - 1e-12) start = i;
  const auto set = [&](size_t i, const Vec3d& right) {
    out[i].right = upright(right, tangents[i]);
    out[i].up = out[i].right.cross(tangents[i]);
  };
  if (n == 0) return out;
  const Vec3d& t = tangents[start];
  set(start, gravity_weight(t) > 0 ? t.cross(Vec3d(0, 1, 0)).normalized()
                                   : perpendicular(Vec3d(1, 0, 0), t));
  for (size_t i = start + 1; i < n; ++i)
    set(i, transported(out[i - 1].right, points[i] - points[i - 1], tangents[i - 1], tangents[i]));
  for (size_t i = start; i-- > 0;)
    set(i, transported(out[i + 1].right, points[i] - points[i + 1], tangents[i + 1], tangents[i]));
  return out;
}

}  // namespace vug::passages
