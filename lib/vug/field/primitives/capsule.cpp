// SPDX-License-Identifier: Apache-2.0
// The exact distance to a ball swept along a straight line (quilez2008distance), and the union of
// such solids along a path.
#include <vug/field/path.h>
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct CapsuleShape {
  Vec3d a, b;
  double radius;
  Vec3d axis = b - a;
  double inverse = axis.length2() > 0 ? 1 / axis.length2() : 0;

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> from_a = p - constant<T>(a), along = constant<T>(axis);
    const T share = clamp(dot(from_a, along) * T(inverse), T(0.0), T(1.0));
    return length(from_a - along * share) - T(radius);
  }
  Box3d bounds() const {
    Box3d box(a);
    box.extendBy(b);
    return grown(box, radius);
  }
  CapsuleShape translated(const Vec3d& by) const { return {a + by, b + by, radius}; }
};

struct Capsule {
  double radius = 0.5;
  double height = 1;
  std::optional<Vec3d> a, b;
  std::optional<std::vector<Vec3d>> path;

  static void describe(Schema<Capsule>& s) {
    s.doc("A ball swept along a straight line or a path: a rod with round ends, a pipe.")
        .cite("quilez2008distance")
        .param("radius", &Capsule::radius, positive_length("radius of the ball"))
        .param("height", &Capsule::height,
               {.doc = "length of the line, which runs along y about the origin, unless a and b "
                       "are given",
                .dimension = Dimension::length,
                .min = 0})
        .param("a", &Capsule::a, any_length("start of the line"))
        .param("b", &Capsule::b, any_length("end of the line"))
        .param("path", &Capsule::path,
               any_length("points of a path, along which the ball is swept instead of a line"));
  }
  std::string fault() const {
    if (path && (a || b)) return "a capsule takes a path or the ends a and b, not both";
    if (path) return path_fault(*path);
    return a.has_value() != b.has_value() ? "a capsule needs both ends a and b, or neither" : "";
  }
  Field make() const {
    const Vec3d up(0, 0.5 * height, 0);
    const std::vector<Vec3d> line = {a.value_or(-up), b.value_or(up)};
    return along_path(path.value_or(line), [&](const Vec3d& from, const Vec3d& to, size_t) {
      return primitive_field("capsule", CapsuleShape{from, to, radius});
    });
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(capsule) {
  return field_kind<Capsule>("capsule", "primitive", [](const Capsule& c) { return c.make(); });
}
