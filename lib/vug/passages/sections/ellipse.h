// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the signed distance to an ellipse, for doubles and packs.
#pragma once

#include <vug/field/numbers/pack.h>
#include <vug/passages/section.h>

#include <cmath>
#include <type_traits>

namespace vug::passages {

/// Largest number of steps that ellipse_distance needs at this ratio of the longer to the shorter
/// half-axis in single precision: the value is then too low by less than 1e-6 of the longer
/// half-axis up to 10:1, and less than 1e-5 up to 100:1.
inline int ellipse_steps(double ratio) {
  return ratio <= 2 ? 3 : ratio <= 10 ? 4 : ratio <= 30 ? 6 : 9;
}

/// The point of the ellipse nearest to (x, y) is (a^2 x / (s + g), b^2 y / s) for a >= b, with
/// g = a^2 - b^2 and s the largest root of |(a x / (s + g), b y / s)| = 1 (eberly2013ellipsoid).
/// The reciprocal of that length is concave and nearly linear in s, so Halley's method converges
/// cubically from the lower bound max(b y, a x - g), until the next step has no effect. The value n
/// . p - h(n), with h the support function of the ellipse, is a lower bound of the distance for any
/// unit normal n, and its error is quadratic in that of n.
template <class S>
inline __attribute__((always_inline)) PlaneDistance<S> ellipse_distance(const S& half_u,
                                                                        const S& half_v, const S& u,
                                                                        const S& v, int steps) {
  using field::abs, field::max, field::min, field::select, field::sign, field::sqrt, field::square;
  constexpr bool kDouble = std::is_same_v<S, double>;
  const auto upright = half_u < half_v;
  const S across(abs(u)), up(abs(v));
  const S b = min(half_u, half_v), unit = S(1.0) / b;
  // In units of b. A point on the longer axis lies next to it instead.
  const S a = max(half_u, half_v) * unit;
  const S x = select(upright, up, across) * unit, y = select(upright, across, up) * unit;
  const S ax = a * x, by = max(y, S(kDouble ? 1e-18 : 1e-9)), g = (a - S(1.0)) * (a + S(1.0));
  const S least = max(by, ax - g);
  S s = least;
  for (int i = 0; i < (kDouble ? 60 : steps); ++i) {
    const S inverse = S(1.0) / (s * (s + g));
    const S i1 = s * inverse, i2 = (s + g) * inverse;
    const S qx = square(ax * i1), qy = square(by * i2), q2 = qx + qy, off = sqrt(q2) - S(1.0);
    const S d1 = qx * i1 + qy * i2, d2 = qx * i1 * i1 + qy * i2 * i2, d11 = d1 * d1;
    const S below = max(d11 + S(1.5) * off * (d11 - d2 * q2), S(0.2) * d11);
    const S step = off * q2 * d1 / max(below, S(kDouble ? 1e-300 : 1e-37));
    s = max(s + step, least);
    if constexpr (kDouble) {
      if (std::fabs(step) < 1e-7 * s) break;
    } else if (!any(abs(step) > S(0.05) * s)) {
      break;  // The error of s is of the third order in the step, that of the value of the sixth.
    }
  }
  const S inverse = S(1.0) / (s * (s + g));
  const S nx = x * s * inverse, ny = by * (s + g) * inverse;
  const S size = S(1.0) / max(sqrt(square(nx) + square(ny)), S(1e-18));
  const S mx = nx * size, my = ny * size;
  const S value = (mx * x + my * y - sqrt(square(a * mx) + square(my))) * b;
  return {value, select(upright, my, mx) * sign(u), select(upright, mx, my) * sign(v)};
}

}  // namespace vug::passages
