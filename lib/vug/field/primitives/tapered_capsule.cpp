// SPDX-License-Identifier: Apache-2.0
#include <vug/field/path.h>
#include <vug/field/primitive.h>
#include <vug/field/round_cone.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::field {
namespace {

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
    return round_cone_nests(a, b, radius_a, radius_b)
               ? "one ball of a tapered capsule lies inside the other; increase the distance of "
                 "their centres"
               : "";
  }
  std::string fault_of_path() const {
    if (path->size() != radii->size())
      return fmt::format("a path of {0} points needs {0} radii, not {1}", path->size(),
                         radii->size());
    for (size_t i = 1; i < path->size(); ++i)
      if (round_cone_nests((*path)[i - 1], (*path)[i], (*radii)[i - 1], (*radii)[i]))
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
      return primitive_field("tapered_capsule", RoundCone{from, to, sizes[i], sizes[i + 1]});
    });
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(tapered_capsule) {
  return field_kind<TaperedCapsule>("tapered_capsule", "primitive",
                                    [](const TaperedCapsule& c) { return c.make(); });
}
