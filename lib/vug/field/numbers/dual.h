// SPDX-License-Identifier: Apache-2.0
// A value with its derivatives along x, y and z, for the gradient mode of a formula, over doubles
// or packs. Forward mode: the point's coordinates are seeded with unit derivatives.
#pragma once

#include <vug/field/numbers/pack.h>

namespace vug::field {

template <class S>
struct Dual {
  S v, dx, dy, dz;

  Dual() : v(0.0), dx(0.0), dy(0.0), dz(0.0) {}
  Dual(double value) : v(value), dx(0.0), dy(0.0), dz(0.0) {}  // NOLINT: a number is a constant
  Dual(S value, S x, S y, S z) : v(value), dx(x), dy(y), dz(z) {}
};

/// f(a), given the value and derivative of f there.
template <class S>
Dual<S> chain(S value, S slope, const Dual<S>& a) {
  return {value, slope * a.dx, slope * a.dy, slope * a.dz};
}

template <class S>
Dual<S> operator+(const Dual<S>& a, const Dual<S>& b) {
  return {a.v + b.v, a.dx + b.dx, a.dy + b.dy, a.dz + b.dz};
}
template <class S>
Dual<S> operator-(const Dual<S>& a, const Dual<S>& b) {
  return {a.v - b.v, a.dx - b.dx, a.dy - b.dy, a.dz - b.dz};
}
template <class S>
Dual<S> operator-(const Dual<S>& a) {
  return {-a.v, -a.dx, -a.dy, -a.dz};
}
template <class S>
Dual<S> operator*(const Dual<S>& a, const Dual<S>& b) {
  return {a.v * b.v, a.dx * b.v + a.v * b.dx, a.dy * b.v + a.v * b.dy, a.dz * b.v + a.v * b.dz};
}
template <class S>
Dual<S> square(const Dual<S>& a) {
  return chain(a.v * a.v, a.v + a.v, a);
}
template <class S>
Dual<S> operator/(const Dual<S>& a, const Dual<S>& b) {
  const S inverse = S(1.0) / b.v, quotient = a.v * inverse;
  return {quotient, (a.dx - quotient * b.dx) * inverse, (a.dy - quotient * b.dy) * inverse,
          (a.dz - quotient * b.dz) * inverse};
}
template <class S>
Dual<S> operator+(const Dual<S>& a, double b) {
  return {a.v + S(b), a.dx, a.dy, a.dz};
}
template <class S>
Dual<S> operator-(const Dual<S>& a, double b) {
  return {a.v - S(b), a.dx, a.dy, a.dz};
}
template <class S>
Dual<S> operator+(double a, const Dual<S>& b) {
  return b + a;
}
template <class S>
Dual<S> operator-(double a, const Dual<S>& b) {
  return {S(a) - b.v, -b.dx, -b.dy, -b.dz};
}
template <class S>
Dual<S> operator*(const Dual<S>& a, double b) {
  return chain(a.v * S(b), S(b), a);
}
template <class S>
Dual<S> operator*(double a, const Dual<S>& b) {
  return b * a;
}
template <class S>
Dual<S> operator/(const Dual<S>& a, double b) {
  return a * (1.0 / b);
}
template <class S>
Dual<S> operator/(double a, const Dual<S>& b) {
  return Dual<S>(a) / b;
}
template <class S>
Dual<S>& operator+=(Dual<S>& a, const Dual<S>& b) {
  return a = a + b;
}
template <class S>
Dual<S>& operator-=(Dual<S>& a, const Dual<S>& b) {
  return a = a - b;
}
template <class S>
Dual<S>& operator*=(Dual<S>& a, const Dual<S>& b) {
  return a = a * b;
}

template <class S>
auto operator<(const Dual<S>& a, const Dual<S>& b) {
  return a.v < b.v;
}
template <class S>
auto operator>(const Dual<S>& a, const Dual<S>& b) {
  return a.v > b.v;
}
template <class S>
auto operator<=(const Dual<S>& a, const Dual<S>& b) {
  return a.v <= b.v;
}
template <class S>
auto operator>=(const Dual<S>& a, const Dual<S>& b) {
  return a.v >= b.v;
}

template <class Mask, class S>
Dual<S> select(Mask m, const Dual<S>& yes, const Dual<S>& no) {
  return {select(m, yes.v, no.v), select(m, yes.dx, no.dx), select(m, yes.dy, no.dy),
          select(m, yes.dz, no.dz)};
}
template <class S>
Dual<S> min(const Dual<S>& a, const Dual<S>& b) {
  return select(a.v < b.v, a, b);
}
template <class S>
Dual<S> max(const Dual<S>& a, const Dual<S>& b) {
  return select(a.v > b.v, a, b);
}
template <class S>
Dual<S> abs(const Dual<S>& a) {
  return select(a.v < S(0.0), -a, a);
}
/// The derivative at 0 is defined as 0, because a distance has no direction there.
template <class S>
Dual<S> sqrt(const Dual<S>& a) {
  const S root = sqrt(a.v);
  const auto positive = root > S(0.0);
  return chain(root, select(positive, S(0.5) / select(positive, root, S(1.0)), S(0.0)), a);
}
template <class S>
Dual<S> floor(const Dual<S>& a) {
  return {floor(a.v), S(0.0), S(0.0), S(0.0)};
}
template <class S>
Dual<S> sin(const Dual<S>& a) {
  return chain(sin(a.v), cos(a.v), a);
}
template <class S>
Dual<S> cos(const Dual<S>& a) {
  return chain(cos(a.v), -sin(a.v), a);
}
template <class S>
Dual<S> exp(const Dual<S>& a) {
  const S e = exp(a.v);
  return chain(e, e, a);
}
template <class S>
Dual<S> atan2(const Dual<S>& y, const Dual<S>& x) {
  const S squared = max(x.v * x.v + y.v * y.v, S(1e-30));
  const S slope_y = x.v / squared, slope_x = -y.v / squared;
  return {atan2(y.v, x.v), slope_y * y.dx + slope_x * x.dx, slope_y * y.dy + slope_x * x.dy,
          slope_y * y.dz + slope_x * x.dz};
}

}  // namespace vug::field
