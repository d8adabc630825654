// SPDX-License-Identifier: Apache-2.0
// The distance to a triangle whose thickness is linear over it.
#pragma once

#include <vug/field/numbers/value_of.h>
#include <vug/field/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace vug::field {

/// A product with a coefficient that has no derivatives, and a sum.
template <class S>
S scaled(const S& a, const S& c) {
  return a * c;
}
template <class S>
Dual<S> scaled(const Dual<S>& a, const S& c) {
  return chain(a.v * c, c, a);
}
template <class S>
S shifted(const S& a, const S& c) {
  return a + c;
}
template <class S>
Dual<S> shifted(const Dual<S>& a, const S& c) {
  return {a.v + c, a.dx, a.dy, a.dz};
}

/// The numbers of a triangle, or of one triangle for each lane of S.
template <class S>
struct Facet {
  Point<S> a, edge1, edge2;         ///< Corners a, a + edge1, a + edge2.
  S square1, square2, mixed, rest;  ///< Products of the edges; square1 - mixed.
  S inverse1, inverse2, inverse3, inverse_area;
  S empty;                 ///< 1 for triangles without an area, which have no inside; else 0.
  S radius, rise1, rise2;  ///< Half the thickness at a; its changes along the edges.

  template <class To>
  Facet<To> as() const {
    const auto point = [](const Point<S>& p) { return Point<To>{To(p.x), To(p.y), To(p.z)}; };
    return {point(a),         point(edge1), point(edge2), To(square1),  To(square2),
            To(mixed),        To(rest),     To(inverse1), To(inverse2), To(inverse3),
            To(inverse_area), To(empty),    To(radius),   To(rise1),    To(rise2)};
  }

  /// The nearest point is the foot of the perpendicular if it lies in the triangle, else on the
  /// nearest side. All are compared, so that no lane of a batch branches; derivatives are those of
  /// the nearest.
  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> q{shifted(p.x, -a.x), shifted(p.y, -a.y), shifted(p.z, -a.z)};
    const T zero(0.0), one(1.0);
    const T d1 = along(q, edge1), d2 = along(q, edge2);
    const T t1 = clamp(scaled(d1, inverse1), zero, one);
    const T t2 = clamp(scaled(d2, inverse2), zero, one);
    const T t3 = clamp(scaled(shifted(-d1, rest) + d2, inverse3), zero, one);
    const T u = scaled(scaled(d1, square2) - scaled(d2, mixed), inverse_area);
    const T v = scaled(scaled(d2, square1) - scaled(d1, mixed), inverse_area);

    const Point<S> q_value{value_of(q.x), value_of(q.y), value_of(q.z)};
    const auto at = [&](const T& share1, const T& share2) {
      return squared(q_value, value_of(share1), value_of(share2));
    };
    const S on1 = at(t1, zero), on2 = at(zero, t2), on3 = at(one - t3, t3);
    S least = on1;
    const auto second = on2 < least;
    least = select(second, on2, least);
    const auto third = on3 < least;
    least = select(third, on3, least);
    // The least barycentric coordinate.
    const S within = min(min(value_of(u), value_of(v)), S(1.0) - value_of(u) - value_of(v)) - empty;
    const auto flat = within >= S(0.0);

    const T side1 = select(third, one - t3, select(second, zero, t1));
    const T side2 = select(third, t3, select(second, t2, zero));
    const T share1 = select(flat, u, side1), share2 = select(flat, v, side2);
    const T thickness = shifted(scaled(share1, rise1), radius) + scaled(share2, rise2);
    if constexpr (std::is_same_v<T, S>)
      return sqrt(select(flat, at(u, v), least)) - thickness;
    else
      return sqrt(squared(q, share1, share2)) - thickness;
  }

 private:
  template <class T>
  static T along(const Point<T>& q, const Point<S>& edge) {
    return scaled(q.x, edge.x) + scaled(q.y, edge.y) + scaled(q.z, edge.z);
  }
  /// |q - u edge1 - v edge2|^2
  template <class T>
  T squared(const Point<T>& q, const T& u, const T& v) const {
    const Point<T> away{q.x - scaled(u, edge1.x) - scaled(v, edge2.x),
                        q.y - scaled(u, edge1.y) - scaled(v, edge2.y),
                        q.z - scaled(u, edge1.z) - scaled(v, edge2.z)};
    return dot(away, away);
  }
};

inline Facet<double> make_facet(const std::array<Vec3d, 3>& p, const std::array<double, 3>& r) {
  const Vec3d edge1 = p[1] - p[0], edge2 = p[2] - p[0];
  const double square1 = edge1.length2(), square2 = edge2.length2(), mixed = edge1.dot(edge2);
  const auto inverse = [](double x) { return x > 1e-24 ? 1 / x : 0; };
  const double area = inverse(square1 * square2 - mixed * mixed);
  return {point(p[0]),
          point(edge1),
          point(edge2),
          square1,
          square2,
          mixed,
          square1 - mixed,
          inverse(square1),
          inverse(square2),
          inverse(square1 + square2 - 2 * mixed),
          area,
          area > 0 ? 0.0 : 1.0,
          r[0],
          r[1] - r[0],
          r[2] - r[0]};
}

/// The slope of the thickness.
inline double slope(const Facet<double>& f) {
  // The gradient of the radius within the plane, from the inverse of the metric.
  const double along1 = (f.rise1 * f.square2 - f.rise2 * f.mixed) * f.inverse_area,
               along2 = (f.rise2 * f.square1 - f.rise1 * f.mixed) * f.inverse_area;
  return std::sqrt(std::max(0.0, along1 * f.rise1 + along2 * f.rise2));
}

/// A box around the solid.
inline Box3d box_of(const Facet<double>& f) {
  const Vec3d a = vector(f.a);
  Box3d out(a);
  out.extendBy(a + vector(f.edge1));
  out.extendBy(a + vector(f.edge2));
  return grown(out, std::max({f.radius, f.radius + f.rise1, f.radius + f.rise2}));
}

}  // namespace vug::field
