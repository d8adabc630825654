// SPDX-License-Identifier: Apache-2.0
// The exact distance to the convex hull of two balls (a "round cone", quilez2008distance). The
// nearest surface point lies on the normal through p; the normals of the slanted part leave the
// axis at a fixed slope, so the projection of p onto the axis along that slope decides which of
// three parts is nearest.
#include <vug/field/path.h>
#include <vug/field/primitive.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::field {
namespace {

struct TaperedCapsuleShape {
  Vec3d a, b;
  double radius_a, radius_b;
  double length_ab = (b - a).length();
  Vec3d axis = (b - a) / length_ab;
  double sine = (radius_a - radius_b) / length_ab;
  double cosine = std::sqrt(1 - sine * sine);

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> from_a = p - constant<T>(a);
    const T y = dot(from_a, constant<T>(axis));
    const T x = length(from_a - constant<T>(axis) * y);
    const T foot = y - x * T(sine / cosine);
    const T at_b = length(x, y - T(length_ab)) - T(radius_b);
    const T slant = x * T(cosine) + y * T(sine) - T(radius_a);
    return select(foot < T(0.0), length(x, y) - T(radius_a),
                  select(foot > T(length_ab), at_b, slant));
  }
  Box3d bounds() const { return united(grown(Box3d(a), radius_a), grown(Box3d(b), radius_b)); }
};

bool is_inside_another(const Vec3d& a, const Vec3d& b, double radius_a, double radius_b) {
  return std::fabs(radius_a - radius_b) >= (b - a).length();
}

struct TaperedCapsule {
  Vec3d a{0, -0.5, 0};
  Vec3d b{0, 0.5, 0};
  double radius_a = 0.5;
  double radius_b = 0.25;
  std::optional<std::vector<Vec3d>> path;
  std::optional<std::vector<double>> radii;

  static void describe(Schema<TaperedCapsule>& s) {
    s.doc(
         "Two balls and the region between them: a rod with round ends of two sizes. Or "
         "a path of such rods.")
        .cite("quilez2008distance")
        .param("a", &TaperedCapsule::a, any_length("centre of the first ball"))
        .param("b", &TaperedCapsule::b, any_length("centre of the second ball"))
        .param("radius_a", &TaperedCapsule::radius_a, positive_length("radius of the first ball"))
        .param("radius_b", &TaperedCapsule::radius_b, positive_length("radius of the second ball"))
        .param("path", &TaperedCapsule::path,
               any_length("centres of more balls, instead of the two; needs their radii"))
        .param("radii", &TaperedCapsule::radii, positive_length("radii of the balls of the path"));
  }
  std::string fault() const {
    if (path.has_value() != radii.has_value())
      return "a path needs 'radii', and 'radii' need a 'path'";
    if (path) return fault_of_path();
    return is_inside_another(a, b, radius_a, radius_b)
               ? "one ball of a tapered capsule lies inside the other; increase the distance of "
                 "their centres"
               : "";
  }
  std::string fault_of_path() const {
    if (path->size() != radii->size())
      return fmt::format("a path of {0} points needs {0} radii, not {1}", path->size(),
                         radii->size());
    for (size_t i = 1; i < path->size(); ++i)
      if (is_inside_another((*path)[i - 1], (*path)[i], (*radii)[i - 1], (*radii)[i]))
        return fmt::format(
            "one of the balls {} and {} of the path lies inside the other; increase the distance "
            "of their centres",
            i, i + 1);
    return path_fault(*path);
  }
  Field make() const {
    const std::vector<Vec3d> centres = path.value_or(std::vector{a, b});
    const std::vector<double> sizes = radii.value_or(std::vector{radius_a, radius_b});
    return along_path(centres, [&](const Vec3d& from, const Vec3d& to, size_t i) {
      return primitive_field("tapered_capsule",
                             TaperedCapsuleShape{from, to, sizes[i], sizes[i + 1]});
    });
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(tapered_capsule) {
  return field_kind<TaperedCapsule>("tapered_capsule", "primitive",
                                    [](const TaperedCapsule& c) { return c.make(); });
}
