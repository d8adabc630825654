// SPDX-License-Identifier: Apache-2.0
// The hollows of a scalloped wall: each has the profile that was measured on scallops, and crests
// form where two hollows meet.
#pragma once

#include <vug/field/point.h>

#include <cstdint>

namespace vug::field {

/// Depth over length of a scallop along the flow (blumberg1974), for x from 0 at its upstream crest
/// to 1, continued by its tangents on both sides. The upstream wall slopes by 26 degrees, the
/// downstream wall by 8; the greatest depth is 0.12533 at x = kScallopDeepest.
template <class T>
T scallop_profile(const T& x) {
  const T inside = clamp(x, T(0.0), T(1.0));
  const T s = sin(inside * T(kPi)), c = cos(inside * T(kPi));
  const T depth = s * (T(0.112) + c * T(2 * 0.028) - T(0.004) * (T(3.0) - square(s) * T(4.0)));
  return depth + T(kPi * (0.112 + 2 * 0.028 - 3 * 0.004)) * min(x, T(0.0)) -
         T(kPi * (0.112 - 2 * 0.028 - 3 * 0.004)) * max(x - T(1.0), T(0.0));
}
inline constexpr double kScallopDeepest = 0.3984;
inline constexpr double kScallopDepth = 0.12534;  ///< Bound of the profile.

/// A hollow: the vector from its deepest point, and its length. The unit is the Sauter mean of the
/// lengths, x runs downstream.
template <class S>
struct ScallopPit {
  Point<S> offset;
  S length;

  /// Below the level at which the crests of equal hollows would meet.
  S depth() const {
    return length * scallop_profile(offset.x / length + S(kScallopDeepest)) -
           (square(offset.y) + square(offset.z)) / (length * S(2.0));
  }
};

/// The deepest hollow at p, one of those that a lattice scatters. Hollows whose depth is below
/// -kScallopRim may be missing.
ScallopPit<double> deepest_scallop(const Point<double>& p, uint32_t seed);
ScallopPit<Pack> deepest_scallop(const Point<Pack>& p, uint32_t seed);
template <class S>
ScallopPit<Dual<S>> deepest_scallop(const Point<Dual<S>>& p, uint32_t seed) {
  const auto pit = deepest_scallop(Point<S>{p.x.v, p.y.v, p.z.v}, seed);
  auto moving = [](const S& v, const Dual<S>& c) { return Dual<S>(v, c.dx, c.dy, c.dz); };
  const S zero(0.0);
  return {{moving(pit.offset.x, p.x), moving(pit.offset.y, p.y), moving(pit.offset.z, p.z)},
          {pit.length, zero, zero, zero}};
}

inline constexpr double kScallopRim = 0.12;
inline constexpr double kLongestScallop = 1.4;  ///< The shortest is 1 / 1.4.

}  // namespace vug::field
