// SPDX-License-Identifier: Apache-2.0
// A thin hexagonal plate, as one of many elements.
#pragma once

#include <vug/field/node.h>

#include <array>
#include <cmath>

namespace vug::field {

/// The maximum of the distances to its faces and to the ball around it: at most the distance to its
/// surface.
class HexPlate {
 public:
  /// `axis` is the unit normal of the plate and `side` a unit vector in it, towards the middle of
  /// an edge. `inner` is the distance from the centre to an edge, `half` half of the thickness,
  /// metres.
  HexPlate(const Vec3d& centre, const Vec3d& axis, const Vec3d& side, double inner, double half)
      : centre_(centre), axis_(axis), inner_(inner), half_(half) {
    constexpr double kSine = 0.86602540378443865;
    const Vec3d other = axis.cross(side);
    sides_ = {side, side * 0.5 + other * kSine, side * 0.5 - other * kSine};
    radius_ = std::sqrt(inner * inner / (kSine * kSine) + half * half);
  }

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> q = p - constant<T>(centre_);
    T most = max(length(q) - T(radius_), abs(dot(q, constant<T>(axis_))) - T(half_));
    for (const Vec3d& side : sides_) most = max(most, abs(dot(q, constant<T>(side))) - T(inner_));
    return most;
  }
  Ball ball() const { return {centre_, radius_}; }

  void add_to(Digester& digester) const { digester(centre_, axis_, sides_, inner_, half_); }

 private:
  Vec3d centre_, axis_;
  std::array<Vec3d, 3> sides_;
  double inner_, half_, radius_ = 0;
};

}  // namespace vug::field
