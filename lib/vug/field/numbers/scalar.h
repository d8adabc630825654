// SPDX-License-Identifier: Apache-2.0
// The vocabulary of field formulas for doubles. A formula is a template over a number type T and
// uses only these names; pack.h, dual.h and interval.h define the other evaluation modes.
#pragma once

#include <vug/base/maths.h>

#include <cmath>

namespace vug::field {

inline double sqrt(double x) { return std::sqrt(x); }
inline double abs(double x) { return std::fabs(x); }
inline double min(double a, double b) { return a < b ? a : b; }
inline double max(double a, double b) { return a > b ? a : b; }
inline double floor(double x) { return std::floor(x); }
inline double sin(double x) { return maths::sin(x); }
inline double cos(double x) { return maths::cos(x); }
inline double exp(double x) { return maths::exp(x); }
inline double atan2(double y, double x) { return maths::atan2(y, x); }
/// `yes` if the condition holds, otherwise `no`; both are computed.
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

/// The conjunction of two comparisons.
template <class Mask>
Mask both(const Mask& a, const Mask& b) {
  return Mask(a & b);
}
template <class T>
T square(const T& x) {
  return x * x;
}
template <class T>
T clamp(const T& x, const T& low, const T& high) {
  return min(max(x, low), high);
}
/// -1 below zero and 1 elsewhere; no formula here needs 0 at zero.
template <class T>
T sign(const T& x) {
  return select(x < T(0.0), T(-1.0), T(1.0));
}
template <class T>
T mix(const T& a, const T& b, const T& t) {
  return a + (b - a) * t;
}

}  // namespace vug::field
