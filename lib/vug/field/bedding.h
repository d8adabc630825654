// SPDX-License-Identifier: Apache-2.0
// Planes at irregular distances along an axis: bed boundaries and joints.
#pragma once

#include <vug/field/lattice.h>

namespace vug::field {

/// The bed around height u, for a mean bed thickness of 1: boundary k lies at k + 0.8 (random -
/// 1/2), so a bed is 0.2 to 1.8 thick.
template <class T>
struct Bed {
  T index;         ///< Integer number of the bed; boundary `index` is its lower face.
  T below, above;  ///< Distances to the lower and upper face in mean thicknesses; >= 0.
};
inline constexpr double kThinnestBed = 0.2;

template <class T>
Bed<T> bed_at(const T& u, uint32_t seed) {
  auto boundary = [&](const T& k) { return k + lattice_random(k, seed) * T(0.8) - T(0.4); };
  const T k = floor(u), one(1.0);
  const T foot = boundary(k), top = boundary(k + one);
  const auto under = u < foot;
  const auto over = u >= top;
  const T low = select(under, boundary(k - one), select(over, top, foot));
  const T high = select(under, foot, select(over, boundary(k + T(2.0)), top));
  return {select(under, k - one, select(over, k + one, k)), u - low, high - u};
}

/// A height along `normal` (unit, scaled by 1/thickness per metre), with surfaces warped by
/// low-frequency noise: u = (normal.p + wander * noise(p / reach)) / thickness.
struct Layering {
  Vec3d normal{0, 1, 0};
  double thickness = 1;  ///< Metres.
  double wander = 0;     ///< Metres.
  double reach = 10;     ///< Metres.
  uint32_t seed = 0;

  template <class T>
  T height(const Point<T>& p) const {
    const T along = p.x * T(normal.x) + p.y * T(normal.y) + p.z * T(normal.z);
    const T bent =
        wander == 0 ? along : along + T(wander) * gradient_noise(p * T(1 / reach), seed ^ 0x5bd1u);
    return bent * T(1 / thickness);
  }
  /// The maximum slope of the height, per metre.
  double slope() const { return (1 + wander * kGradientNoiseSlope / reach) / thickness; }
};

}  // namespace vug::field
