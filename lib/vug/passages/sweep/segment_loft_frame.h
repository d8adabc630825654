// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the constants and formulas of a segment between two ellipses.
#pragma once

#include <vug/field/near_surface.h>
#include <vug/passages/sweep/ellipse_loft_sample.h>
#include <vug/passages/sweep/segment.h>

namespace vug::passages {

/// The constants of a segment as numbers of type S, converted once for a batch: packs may alias
/// everything, so the compiler would convert them again for each point.
template <class S>
struct Segment::AxisFrame {
  explicit AxisFrame(const Segment& segment)
      : length(segment.length_),
        per_length(1 / segment.length_),
        scale(segment.scale_),
        from_depth(segment.from_.depth),
        to_depth(segment.to_.depth) {}

  /// s / L, clamped.
  S share(const S& s) const { return field::clamp(s * per_length, S(0.0), S(1.0)); }
  /// How far s is beyond the ends; not positive between them.
  S beyond(const S& s) const { return field::max(S(0.0) - s, s - length); }
  S depth(const S& s) const { return field::select(s < S(0.0), from_depth, to_depth); }
  /// The formula of Segment::finish for a distance D in the plane, or for a lower bound of it,
  /// without the scale.
  S capped(const S& plane, const S& s) const {
    using field::max, field::select, field::sqrt, field::square;
    const S zero(0.0), outside = beyond(s), deep = depth(s);
    const S cap = sqrt(square(max(plane + deep, zero)) + square(outside)) - deep;
    return select(outside > zero, cap, plane);
  }

  S length, per_length, scale, from_depth, to_depth;
};

/// The frame of a segment with a loft.
template <class S>
struct Segment::LoftFrame : AxisFrame<S> {
  using Axis = AxisFrame<S>;
  explicit LoftFrame(const Segment& segment)
      : Axis(segment),
        start(field::constant<S>(segment.start_)),
        along(field::constant<S>(segment.along_)),
        first(field::constant<S>(segment.loft_->first())),
        second(field::constant<S>(segment.loft_->second())) {}

  /// Coordinates in the plane, along the axis, and s / L clamped.
  struct Coordinates {
    S u, v, s, t;
  };
  Coordinates coordinates(const Point<S>& p) const {
    const Point<S> offset = p - start;
    const S s = dot(offset, along);
    return {dot(offset, first), dot(offset, second), s, Axis::share(s)};
  }

  /// The value and gradient; the formula is that of Segment::finish.
  Dual<S> finish(const EllipseLoft::Sample<S>& d, const S& s) const {
    using field::max, field::select, field::sqrt, field::square;
    const S zero(0.0), outside = Axis::beyond(s), deep = Axis::depth(s);
    const auto past = outside > zero;
    const S height = max(d.value + deep, zero), cap = sqrt(square(height) + square(outside));
    const S inverse = Axis::scale / max(cap, S(1e-18));
    const S value = select(past, cap - deep, d.value) * Axis::scale;
    const S across = select(past, height * inverse, Axis::scale);
    const S on = select(past, select(s < zero, zero - outside, outside) * inverse,
                        d.dt * Axis::scale * Axis::per_length);
    const S u = d.du * across, v = d.dv * across;
    return {value, u * first.x + v * second.x + on * along.x,
            u * first.y + v * second.y + on * along.y, u * first.z + v * second.z + on * along.z};
  }

  /// The same value. Its slope is `scale` beyond the ends and scale |(1, dt / L)| between them.
  field::FirstOrder first_order(const EllipseLoft::Sample<S>& d, const S& s) const {
    using field::select, field::sqrt, field::square;
    const S value = Axis::capped(d.value, s);
    const S slope = sqrt(S(1.0) + square(d.dt * Axis::per_length));
    return {value * Axis::scale, select(Axis::beyond(s) > S(0.0), value, value / slope)};
  }

  Point<S> start, along, first, second;
};

}  // namespace vug::passages
