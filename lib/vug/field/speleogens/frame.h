// SPDX-License-Identifier: Apache-2.0
// Coordinates along a direction and across it, scaled.
#pragma once

#include <vug/base/digester.h>
#include <vug/field/point.h>

#include <cmath>

namespace vug::field {

/// Two unit vectors across a direction: the first one is horizontal, or x along the y axis.
struct Across {
  explicit Across(const Vec3d& direction) {
    const Vec3d along = direction.normalized();
    side =
        std::fabs(along.y) > 1 - 1e-9 ? Vec3d(1, 0, 0) : Vec3d(along.z, 0, -along.x).normalized();
    up = along.cross(side);
  }
  Vec3d side, up;
  void add_to(Digester& digester) const { digester(side, up); }
};

/// x along the direction, y and z across it, each multiplied by its factor. y is turned from the
/// horizontal by an angle whose tangent is 1 over the golden ratio, so that level floors and plumb
/// walls cut a lattice in these coordinates at all of its offsets.
class FlowFrame {
 public:
  FlowFrame(const Vec3d& direction, const Vec3d& factor) {
    constexpr double kCosine = 0.85065080835203999, kSine = 0.52573111211913359;
    const Across across(direction);
    x_ = direction.normalized() * factor.x;
    y_ = (across.side * kCosine + across.up * kSine) * factor.y;
    z_ = (across.up * kCosine - across.side * kSine) * factor.z;
  }
  template <class T>
  Point<T> local(const Point<T>& p) const {
    return {dot(p, constant<T>(x_)), dot(p, constant<T>(y_)), dot(p, constant<T>(z_))};
  }

 private:
  Vec3d x_, y_, z_;
};

}  // namespace vug::field
