// SPDX-License-Identifier: Apache-2.0
// The distance to an ellipsoid, which has no closed form: the nearest point is x_i = e_i^2 y_i / (t
// + e_i^2), where t solves sum_i (e_i y_i / (t + e_i^2))^2 = 1 (eberly2013ellipsoid). Three details
// differ. t results from Newton steps on 1 - 1/sqrt(sum), which is concave and almost straight, so
// the steps increase towards the root. The value is then that of the tangent plane with normal n ~
// x_i / e_i^2, n . p - |e n|: it never exceeds the distance, whatever n, and its error is quadratic
// in the error of n. And the smallest axis is the unit, with s = t + 1 as the unknown, so that
// there is no cancellation near the centre.
#include <vug/field/primitive.h>

#include <algorithm>
#include <type_traits>

namespace vug::field {
namespace {

/// Steps until the bound equals the distance up to the rounding of either number type for axes up
/// to 1:10 (measured: 1e-6 and 1e-11); beyond that the result is a bound.
int steps(const Pack*) { return 10; }
int steps(const double*) { return 20; }

struct EllipsoidShape {
  Vec3d radii;
  double least = std::min({radii.x, radii.y, radii.z});
  Vec3d e = radii / least;
  Vec3d gap = e * e - Vec3d(1.0);  // e_i^2 minus the smallest, which is 1.
  double widest_gap = std::max({gap.x, gap.y, gap.z});

  template <class S>
  S touch(const Point<S>& p, Point<S>& normal) const {
    const Point<S> y = abs(p) * S(1 / least);
    // Positive, so that no axis is lost at the centre, where all directions are equally near.
    const Point<S> b = {max(y.x * S(e.x), S(1e-15)), max(y.y * S(e.y), S(1e-15)),
                        max(y.z * S(e.z), S(1e-15))};
    const S start =
        max(max(b.x - S(gap.x), max(b.y - S(gap.y), b.z - S(gap.z))), length(b) - S(widest_gap));
    S s = start, before = start;
    for (int i = steps(static_cast<S*>(nullptr)); i > 0; --i) {
      const S wx = S(1.0) / (s + S(gap.x)), wy = S(1.0) / (s + S(gap.y)),
              wz = S(1.0) / (s + S(gap.z));
      const S ux = square(b.x * wx), uy = square(b.y * wy), uz = square(b.z * wz);
      const S sum = ux + uy + uz;
      const S next = max(start, s + sum * (sqrt(sum) - S(1.0)) / (ux * wx + uy * wy + uz * wz));
      if constexpr (std::is_same_v<S, double>) {  // The same bits as after all steps.
        if (next == s) break;
        // Rounding alternates between two values; the number of steps left decides which is last.
        if (next == before) {
          if (i % 2 == 1) s = next;
          break;
        }
      }
      before = s;
      s = next;
    }
    const Point<S> en = {b.x / (s + S(gap.x)), b.y / (s + S(gap.y)), b.z / (s + S(gap.z))};
    Point<S> n = {en.x * S(1 / e.x), en.y * S(1 / e.y), en.z * S(1 / e.z)};
    const S size = S(1.0) / length(n);
    n = n * size;
    normal = {n.x * sign(p.x), n.y * sign(p.y), n.z * sign(p.z)};
    return (dot(n, y) - length(en) * size) * S(least);
  }

  template <class T>
  T distance(const Point<T>& p) const {
    Point<T> normal;
    return touch(p, normal);
  }
  template <class S>
  Dual<S> distance(const Point<Dual<S>>& p) const {
    Point<S> normal;
    const S value = touch(Point<S>{p.x.v, p.y.v, p.z.v}, normal);
    return differentiated(value, normal, p);
  }
  /// With k = |p / e|: (k - 1) times the smallest axis is below the distance outside and above it
  /// inside; with the longest axis it is the reverse.
  Interval distance(const Point<Interval>& p) const {
    const Interval k =
        length(Point<Interval>{p.x * (1 / radii.x), p.y * (1 / radii.y), p.z * (1 / radii.z)}) -
        Interval(1);
    const double most = std::max({radii.x, radii.y, radii.z});
    const double low = k.lo < 0 ? std::max(-least, k.lo * most) : k.lo * least;
    return {low, k.hi < 0 ? k.hi * least : k.hi * most};
  }
  Box3d bounds() const { return {-radii, radii}; }
};

struct Ellipsoid {
  Vec3d radii{1, 0.75, 0.5};

  static void describe(Schema<Ellipsoid>& s) {
    s.doc("An ellipsoid about the origin; its distance is exact up to rounding.")
        .cite("eberly2013ellipsoid")
        .param("radii", &Ellipsoid::radii, positive_length("semi-axes along x, y and z"));
  }
  EllipsoidShape shape() const { return {radii}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(ellipsoid) { return primitive_kind<Ellipsoid>("ellipsoid"); }
