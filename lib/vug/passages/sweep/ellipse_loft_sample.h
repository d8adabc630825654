// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the samples of EllipseLoft.
#pragma once

#include <vug/passages/sections/ellipse.h>
#include <vug/passages/sweep/ellipse_loft.h>

namespace vug::passages {

template <class S>
EllipseLoft::Sample<S> EllipseLoft::sample(const S& u, const S& v, const S& t) const {
  using field::max, field::sqrt, field::square;
  const S a = S(a0_) + t * S(a1_);
  if (round_) {
    const S radius = sqrt(square(u) + square(v)), inverse = S(1.0) / max(radius, S(1e-18));
    return {radius - a, u * inverse, v * inverse, S(-a1_)};
  }
  const S b = S(b0_) + t * S(b1_);
  S x = u, y = v, cosine(1.0), sine(0.0), speed(0.0);
  if (turn_ != 0) {  // The frame is the normalised interpolation of both frames.
    const S c = S(1.0) + t * S(cosine_ - 1), s = t * S(sine_);
    const S inverse = S(1.0) / (square(c) + square(s)), size = sqrt(inverse);
    cosine = c * size;
    sine = s * size;
    speed = S(sine_) * inverse;
    x = cosine * u + sine * v;
    y = cosine * v - sine * u;
  }
  const PlaneDistance<S> d = ellipse_distance(a, b, x, y, steps_);
  const S support = d.du * x + d.dv * y - d.value;
  const S growth = (a * S(a1_) * square(d.du) + b * S(b1_) * square(d.dv)) / support;
  return {d.value, cosine * d.du - sine * d.dv, cosine * d.dv + sine * d.du,
          (d.du * y - d.dv * x) * speed - growth};
}

}  // namespace vug::passages
