// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/placement/nearest_air.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

constexpr double kFarthest = 100;
/// The shortest step: values of displaced fields may be far below the distance.
constexpr double kShortestStep = 0.005;
/// Beyond the surface, if there is air.
constexpr double kClearance = 0.1;

/// A length by which the point is at least in rock; 0 in air.
double rock_depth(const Set& set, const Vec3d& p, IsOpen is_open, Accuracy accuracy) {
  double depth = 0;
  for (const SetPiece& piece : set.pieces)
    for (const Solid& solid : piece.solids)
      if (const double d = solid.depth(p, accuracy); d > depth && !(solid.*is_open)(p)) depth = d;
  return depth;
}

std::string side_of(const Vec3d& direction) {
  if (std::fabs(direction.y) > 0.9) return direction.y > 0 ? "above" : "below";
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    if (std::fabs(direction[axis]) > 0.1) {
      text += text.empty() ? "towards " : " and ";
      text += direction[axis] > 0 ? '+' : '-';
      text += "xyz"[axis];
    }
  return text;
}

}  // namespace

std::optional<NearestAir> nearest_air(const Set& set, const Vec3d& p, IsOpen is_open,
                                      Accuracy accuracy) {
  std::optional<NearestAir> best;
  double limit = kFarthest;
  for (int code = 0; code < 27; ++code) {
    if (code == 13) continue;  // no direction
    const int row = code / 3 % 3, slice = code / 9;
    const Vec3d along = Vec3d(code % 3 - 1, row - 1, slice - 1).normalized();
    for (double t = 0; t < limit;) {
      const double depth = rock_depth(set, p + along * t, is_open, accuracy);
      if (depth > 0) {
        t += std::max(depth, kShortestStep);
        continue;
      }
      const Vec3d beyond = p + along * (t + kClearance);
      best = {t, rock_depth(set, beyond, is_open, accuracy) > 0 ? p + along * t : beyond,
              side_of(along)};
      limit = t;
    }
  }
  return best;
}

}  // namespace vug::loading
