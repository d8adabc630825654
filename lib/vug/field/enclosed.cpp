// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/enclosed.h>
#include <vug/field/primitive.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// The exact distance to a box.
struct Enclosure {
  Box3d box;

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> d = abs(p - constant<T>(box.center())) - constant<T>(0.5 * box.size());
    return length(max(d, 0)) + min(max(max(d.x, d.y), d.z), T(0.0));
  }
  Box3d bounds() const { return box; }
  Enclosure translated(const Vec3d& by) const { return {{box.min + by, box.max + by}}; }
};

/// A lower bound of the distance: the difference of radii divided by the steepness of the hull's
/// side.
struct HullSide {
  explicit HullSide(const HullOfRevolution& s)
      : hull(s),
        slope((s.high - s.low) / (s.to - s.from)),
        scale(1 / std::sqrt(1 + slope * slope)) {}
  HullOfRevolution hull;
  double slope, scale;

  template <class T>
  T distance(const Point<T>& p) const {
    const double height = hull.to - hull.from, widening = hull.high - hull.low;
    const T t = clamp((p.y - T(hull.from)) * T(1 / height), T(0.0), T(1.0));
    return (length(p.x, p.z) - (T(hull.low) + t * T(widening))) * T(scale);
  }
  Box3d bounds() const { return infinite_box(); }
  void add_to(Digester& digester) const { digester(hull); }
  Exactness exactness() const { return Exactness::bound; }
  double growth() const { return 0; }
};

template <class P>
Field met(const Field& field, const std::string& name, const P& hull) {
  return intersect({field, Field(std::make_shared<PrimitiveNode<P>>(name, hull))});
}

}  // namespace

Field within_hull(const Field& field, const HullOfRevolution& hull) {
  return met(field, "sleeve", HullSide(hull));
}

Field enclosed(const Field& field, const Box3d& box) {
  return met(field, "enclosure", Enclosure{box});
}

double radius_about_y(const Box3d& box) {
  const double x = std::max(std::fabs(box.min.x), std::fabs(box.max.x));
  const double z = std::max(std::fabs(box.min.z), std::fabs(box.max.z));
  return std::sqrt(x * x + z * z);
}

}  // namespace vug::field
