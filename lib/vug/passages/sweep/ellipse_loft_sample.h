// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the samples of EllipseLoft.
#pragma once

#include <vug/passages/sections/ellipse.h>
#include <vug/passages/sweep/ellipse_loft.h>

namespace vug::passages {

/// The ellipse at a point's t and the point in its frame, which is the normalised interpolation of
/// both frames.
template <class S>
struct EllipseLoft::Slice {
  S a, b, x, y, cosine, sine, speed;
};

/// 1 / sqrt(1 - e) for 0 <= e <= 0.0625, as turns of half a radian have it. The series for packs is
/// exact to 2e-8.
inline double inverse_root(double e) { return 1 / std::sqrt(1 - e); }
inline field::Pack inverse_root(const field::Pack& e) {
  using field::Pack;
  Pack sum(63.0 / 256);
  for (const double term : {35.0 / 128, 5.0 / 16, 3.0 / 8, 1.0 / 2, 1.0})
    sum = sum * e + Pack(term);
  return sum;
}

template <class S>
inline __attribute__((always_inline)) EllipseLoft::Slice<S> EllipseLoft::slice(const S& u,
                                                                               const S& v,
                                                                               const S& t) const {
  using field::sqrt, field::square;
  Slice<S> out{S(a0_) + t * S(a1_), S(b0_) + t * S(b1_), u, v, S(1.0), S(0.0), S(0.0)};
  if (turn_ == 0) return out;
  const S c = S(1.0) + t * S(cosine_ - 1), s = t * S(sine_);
  const S size = inverse_root(S(2 * (1 - cosine_)) * t * (S(1.0) - t)), inverse = square(size);
  out.cosine = c * size;
  out.sine = s * size;
  out.speed = S(sine_) * inverse;
  out.x = out.cosine * u + out.sine * v;
  out.y = out.cosine * v - out.sine * u;
  return out;
}

template <class S>
inline __attribute__((always_inline)) EllipseLoft::Sample<S> EllipseLoft::finish(
    const Slice<S>& at, const EllipseFoot<S>& d) const {
  using field::square;
  const S growth = (at.a * S(a1_) * square(d.du) + at.b * S(b1_) * square(d.dv)) * d.per_support;
  return {d.value, at.cosine * d.du - at.sine * d.dv, at.cosine * d.dv + at.sine * d.du,
          (d.du * at.y - d.dv * at.x) * at.speed - growth};
}

template <class S>
inline __attribute__((always_inline)) EllipseLoft::Sample<S> EllipseLoft::sample_circle(
    const S& u, const S& v, const S& t) const {
  using field::max, field::sqrt, field::square;
  const S radius = sqrt(square(u) + square(v)), inverse = S(1.0) / max(radius, S(1e-18));
  return {radius - (S(a0_) + t * S(a1_)), u * inverse, v * inverse, S(-a1_)};
}

/// With n the normal, at the point, of the ellipse's scaled copy through it, n . p - h(n) is
/// k (k - a b) / g with k = |(b x, a y)| and g = |(b^2 x, a^2 y)|. The frame is turned without
/// being normalised: D is convex and least at the centre, so points nearer to it have lower bounds.
template <class S>
inline __attribute__((always_inline)) S EllipseLoft::least(const S& u, const S& v,
                                                           const S& t) const {
  using field::abs, field::max, field::sqrt, field::square;
  if (round_) return sqrt(square(u) + square(v)) - (S(a0_) + t * S(a1_));
  const S a = S(a0_) + t * S(a1_), b = S(b0_) + t * S(b1_);
  S x = u, y = v;
  if (turn_ != 0) {
    const S c = S(1.0) + t * S(cosine_ - 1), s = t * S(sine_);
    x = c * u + s * v;
    y = c * v - s * u;
  }
  const S bx = b * x, ay = a * max(abs(y), S(1e-9) * b);
  const S k = sqrt(square(bx) + square(ay)), g = sqrt(square(b * bx) + square(a * ay));
  return k * (k - a * b) / g;
}

template <class S>
EllipseLoft::Sample<S> EllipseLoft::sample(const S& u, const S& v, const S& t) const {
  if (round_) return sample_circle(u, v, t);
  const Slice<S> at = slice(u, v, t);
  return finish(at, ellipse_distance(at.a, at.b, at.x, at.y, steps_));
}

}  // namespace vug::passages
