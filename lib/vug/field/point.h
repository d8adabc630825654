// SPDX-License-Identifier: Apache-2.0
// A point with coordinates of any number type, the argument of formulas.
#pragma once

#include <vug/base/vec.h>
#include <vug/field/numbers/dual.h>
#include <vug/field/numbers/interval.h>

#include <type_traits>

namespace vug::field {

template <class T>
struct Point {
  T x, y, z;
};

template <class T>
Point<T> operator+(const Point<T>& a, const Point<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Point<T> operator-(const Point<T>& a, const Point<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Point<T> operator*(const Point<T>& a, const T& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
T dot(const Point<T>& a, const Point<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
T length(const T& x, const T& y) {
  return sqrt(square(x) + square(y));
}
template <class T>
T length(const Point<T>& a) {
  return sqrt(square(a.x) + square(a.y) + square(a.z));
}
template <class T>
Point<T> abs(const Point<T>& a) {
  return {abs(a.x), abs(a.y), abs(a.z)};
}
template <class T>
Point<T> max(const Point<T>& a, double b) {
  return {max(a.x, T(b)), max(a.y, T(b)), max(a.z, T(b))};
}

/// A constant vector as a point of the given number type.
template <class T>
Point<T> constant(const Vec3d& v) {
  return {T(v.x), T(v.y), T(v.z)};
}
inline Point<double> point(const Vec3d& p) { return {p.x, p.y, p.z}; }
inline Vec3d vector(const Point<double>& p) { return {p.x, p.y, p.z}; }

/// A point seeded for differentiation.
template <class S>
Point<Dual<S>> seeded(const Point<S>& p) {
  const S one(1.0), zero(0.0);
  return {{p.x, one, zero, zero}, {p.y, zero, one, zero}, {p.z, zero, zero, one}};
}

/// Converts a point of a batch for a formula over T: seeded if T is differentiated.
template <class T>
Point<T> point_for(const Point<Pack>& p) {
  if constexpr (std::is_same_v<T, Pack>)
    return p;
  else
    return seeded(p);
}

/// A value with known gradient as a function of a point that is itself differentiated.
template <class S>
Dual<S> differentiated(const S& value, const Point<S>& gradient, const Point<Dual<S>>& p) {
  return {value, gradient.x * p.x.dx + gradient.y * p.y.dx + gradient.z * p.z.dx,
          gradient.x * p.x.dy + gradient.y * p.y.dy + gradient.z * p.z.dy,
          gradient.x * p.x.dz + gradient.y * p.y.dz + gradient.z * p.z.dz};
}

template <class S>
Point<S> gradient_of(const Dual<S>& d) {
  return {d.dx, d.dy, d.dz};
}

/// The points of a box as intervals.
inline Point<Interval> region(const Box3d& box) {
  return {{box.min.x, box.max.x}, {box.min.y, box.max.y}, {box.min.z, box.max.z}};
}

}  // namespace vug::field
