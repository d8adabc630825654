// SPDX-License-Identifier: Apache-2.0
// The form of travertine domes, which does not change while water runs down all sides of it.
#pragma once

#include <vug/base/maths.h>

#include <cmath>

namespace vug::field {

/// The radius at which a dome of that scale in metres is inclined by `angle` radians: growth along
/// the normal is that of the whole, V cos(angle), and proportional to the speed of the film,
/// (Q^2 sin(angle) / r^2)^(1/3) (goldenfeld2006). Hence r = scale (sin / cos^3)^(1/2).
inline double dome_radius(double scale, double angle) {
  const double cosine = maths::cos(angle);
  return scale * std::sqrt(maths::sin(angle) / (cosine * cosine * cosine));
}

/// The depth below the apex where it is inclined by `angle`. With s the tangent of the angle,
/// r = scale (s + s^3)^(1/2) and dz = s dr.
inline double dome_depth(double scale, double angle) {
  // In v = s^(1/2): r = scale v (1 + v^4)^(1/2), dr/dv = scale (1 + 3 v^4) / (1 + v^4)^(1/2).
  const double end = std::sqrt(maths::tan(angle));
  constexpr int kPieces = 64;  // Simpson's rule.
  const auto slope = [&](double v) {
    const double fourth = v * v * v * v;
    return scale * v * v * (1 + 3 * fourth) / std::sqrt(1 + fourth);
  };
  double sum = slope(0) + slope(end);
  for (int i = 1; i < kPieces; ++i) sum += (i % 2 ? 4 : 2) * slope(end * i / kPieces);
  return sum * end / (3 * kPieces);
}

}  // namespace vug::field
