// SPDX-License-Identifier: Apache-2.0
// A knob of popcorn: a ball on a stalk, joined by a fillet.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/round_cone.h>

namespace vug::field {

struct Nodule {
  RoundCone stalk;    ///< From the rock to the middle of the ball.
  double radius = 0;  ///< The ball around stalk.b, metres; at least that of the stalk.
  Blend fillet;       ///< Smooth; its depth is less than the radius of the stalk at its foot.

  template <class T>
  T distance(const Point<T>& p) const {
    const T knob = length(p - constant<T>(stalk.b)) - T(radius);
    return fillet.smin(knob, stalk.distance(p));
  }
  Ball ball() const {
    const double half = 0.5 * (stalk.length_ab + stalk.radius_a + radius);
    return {stalk.a + stalk.axis * (half - stalk.radius_a), half + fillet.depth()};
  }
};

}  // namespace vug::field
