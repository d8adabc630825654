// SPDX-License-Identifier: Apache-2.0
// Interval evaluation of a formula: bounds of its value over a box of points (Moore 1966).
#pragma once

#include <vug/base/interval.h>
#include <vug/field/numbers/scalar.h>

namespace vug::field {

/// A comparison of intervals may hold for some points and fail for others.
struct Maybe {
  bool yes;  ///< It holds somewhere.
  bool no;   ///< It fails somewhere.
};
inline Maybe operator&(Maybe a, Maybe b) { return {a.yes && b.yes, a.no || b.no}; }
inline Maybe operator|(Maybe a, Maybe b) { return {a.yes || b.yes, a.no && b.no}; }
inline Maybe operator!(Maybe a) { return {a.no, a.yes}; }

}  // namespace vug::field

// Operators are defined in the namespace of the type, where argument-dependent lookup finds them.
namespace vug {

inline Interval operator+(Interval a, Interval b) { return {a.lo + b.lo, a.hi + b.hi}; }
inline Interval operator-(Interval a, Interval b) { return {a.lo - b.hi, a.hi - b.lo}; }
inline Interval operator-(Interval a) { return {-a.hi, -a.lo}; }
Interval operator*(Interval a, Interval b);
/// The whole line if the divisor contains 0.
Interval operator/(Interval a, Interval b);
inline Interval& operator+=(Interval& a, Interval b) { return a = a + b; }
inline Interval& operator-=(Interval& a, Interval b) { return a = a - b; }
inline Interval& operator*=(Interval& a, Interval b) { return a = a * b; }

inline field::Maybe operator<(Interval a, Interval b) { return {a.lo < b.hi, a.hi >= b.lo}; }
inline field::Maybe operator>(Interval a, Interval b) { return b < a; }
inline field::Maybe operator<=(Interval a, Interval b) { return {a.lo <= b.hi, a.hi > b.lo}; }
inline field::Maybe operator>=(Interval a, Interval b) { return b <= a; }

inline Interval min(Interval a, Interval b) {
  return {field::min(a.lo, b.lo), field::min(a.hi, b.hi)};
}
inline Interval max(Interval a, Interval b) {
  return {field::max(a.lo, b.lo), field::max(a.hi, b.hi)};
}
inline Interval abs(Interval a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return -a;
  return {0, field::max(-a.lo, a.hi)};
}
inline Interval square(Interval a) {
  const Interval m = abs(a);
  return {m.lo * m.lo, m.hi * m.hi};
}
inline Interval sqrt(Interval a) {
  return {std::sqrt(field::max(a.lo, 0)), std::sqrt(field::max(a.hi, 0))};
}
inline Interval floor(Interval a) { return {std::floor(a.lo), std::floor(a.hi)}; }
Interval sin(Interval a);
Interval cos(Interval a);
Interval exp(Interval a);
Interval atan2(Interval y, Interval x);
inline Interval select(field::Maybe m, Interval yes, Interval no) {
  return m.yes && m.no ? hull(yes, no) : m.yes ? yes : no;
}

}  // namespace vug
