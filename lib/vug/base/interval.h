// SPDX-License-Identifier: Apache-2.0
// Closed intervals [lo, hi] of doubles, used to bound a formula over a region.
// Bounds are rounded to nearest, not outwards: callers add a relative slack where it matters.
#pragma once

namespace vug {

struct Interval {
  double lo = 0;
  double hi = 0;

  constexpr Interval() = default;
  constexpr Interval(double value) : lo(value), hi(value) {}  // NOLINT: a number is an interval
  constexpr Interval(double low, double high) : lo(low), hi(high) {}

  constexpr bool contains(double value) const { return lo <= value && value <= hi; }
  constexpr double width() const { return hi - lo; }
  constexpr double middle() const { return 0.5 * (lo + hi); }
};

/// The smallest interval around both.
constexpr Interval hull(Interval a, Interval b) {
  return {a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi};
}

/// The intersection. Both must bound the same value; a gap caused by rounding is treated as
/// overlap.
constexpr Interval intersection(Interval a, Interval b) {
  const double lo = a.lo > b.lo ? a.lo : b.lo;
  const double hi = a.hi < b.hi ? a.hi : b.hi;
  return lo <= hi ? Interval(lo, hi) : Interval(hi, lo);
}

}  // namespace vug
