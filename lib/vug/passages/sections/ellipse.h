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

/// A distance and 1 / h(n), with n the normal at the nearest point and h the support function.
template <class S>
struct EllipseFoot : PlaneDistance<S> {
  S per_support;
};

/// The point of the ellipse nearest to (x, y) is (a^2 x / (s + g), b^2 y / s) for a >= b, with
/// g = a^2 - b^2 and s the largest root of |(a x / (s + g), b y / s)| = 1 (eberly2013ellipsoid).
/// The reciprocal of that length is concave and nearly linear in s, so Halley's method converges
/// cubically from a lower bound, until the next step has no effect. s is convex in g, so its
/// tangent at the circle, g = 0, is a lower bound, and max(b y, a x - g) is another one, at which
/// that length is at most sqrt(2).
template <class S>
class EllipseRoot {
 public:
  EllipseRoot() = default;
  inline __attribute__((always_inline))
  EllipseRoot(const S& half_u, const S& half_v, const S& u, const S& v)
      : u_(u), v_(v), upright_(half_u < half_v) {
    using field::abs, field::max, field::min, field::select, field::sqrt, field::square;
    const S across(abs(u)), up(abs(v));
    b_ = min(half_u, half_v);
    per_b_ = S(1.0) / b_;
    a_ = max(half_u, half_v) * per_b_;
    x_ = select(upright_, up, across) * per_b_;
    y_ = select(upright_, across, up) * per_b_;
    const S g = gap(), xx = square(a_ * x_), q = xx + square(raised());
    s_ = max(least(), sqrt(q) - g * xx / q);
  }

  /// One step; returns whether another one has an effect. With q2 the square of the length, the
  /// step needs sqrt(q2) - 1, and 2 (q2 - 1) / (q2 + 3) has the same first two derivatives at 1.
  inline __attribute__((always_inline)) bool step() {
    using field::abs, field::max, field::square;
    const S ax = a_ * x_, by = raised(), more = s_ + gap();
    const S inverse = S(1.0) / (s_ * more), i1 = s_ * inverse, i2 = more * inverse;
    scale_ = inverse;
    const S qx = square(ax * i1), qy = square(by * i2), q2 = qx + qy;
    const S off = S(2.0) * (q2 - S(1.0)), of = q2 + S(3.0);
    const S d1 = qx * i1 + qy * i2, d2 = qx * i1 * i1 + qy * i2 * i2, d11 = d1 * d1;
    const S below = max(of * d11 + S(1.5) * off * (d11 - d2 * q2), S(0.2) * of * d11);
    const S change = off * q2 * d1 / max(below, S(kDouble ? 1e-300 : 1e-37));
    s_ = max(s_ + change, least());
    if constexpr (kDouble)
      return !(std::fabs(change) < 1e-5 * s_);
    else  // The error of s is of the third order in the step, that of the value of the sixth.
      return any(abs(change) > S(0.05) * s_);
  }

  /// n . p - h(n), with n the normal at the nearest point and h the support function of the
  /// ellipse: a lower bound of the distance for any unit vector n, with an error that is quadratic
  /// in that of n.
  inline __attribute__((always_inline)) EllipseFoot<S> distance() const {
    using field::max, field::select, field::sign, field::sqrt, field::square;
    const S nx = x_ * s_ * scale_, ny = raised() * (s_ + gap()) * scale_;
    const S length2 = square(nx) + square(ny), length = sqrt(length2),
            support = sqrt(square(a_ * nx) + square(ny));
    const S inverse = S(1.0) / max(length * support, S(kDouble ? 1e-300 : 1e-37)),
            size = support * inverse;
    const S mx = nx * size, my = ny * size;
    const S value = (nx * x_ + ny * y_ - support) * size * b_;
    return {{value, select(upright_, my, mx) * sign(u_), select(upright_, mx, my) * sign(v_)},
            length2 * inverse * per_b_};
  }

 private:
  static constexpr bool kDouble = std::is_same_v<S, double>;
  S gap() const { return (a_ - S(1.0)) * (a_ + S(1.0)); }
  /// A point on the longer axis lies next to it instead.
  S raised() const { return field::max(y_, S(kDouble ? 1e-18 : 1e-9)); }
  S least() const { return field::max(raised(), a_ * x_ - gap()); }

  S u_, v_, b_, per_b_;
  S a_, x_, y_, s_;  // In units of b_; x along the longer axis.
  S scale_{1.0};     // 1 / (s (s + g)) of the last step: normals have a length near 1.
  decltype(S() < S()) upright_;
};

template <class S>
inline __attribute__((always_inline)) EllipseFoot<S> ellipse_distance(const S& half_u,
                                                                      const S& half_v, const S& u,
                                                                      const S& v, int steps) {
  EllipseRoot<S> root(half_u, half_v, u, v);
  for (int i = 0; i < (std::is_same_v<S, double> ? 60 : steps) && root.step(); ++i) {
  }
  return root.distance();
}

}  // namespace vug::passages
