// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/kind.h>
#include <vug/field/lathe.h>
#include <vug/field/speleothems/stalagmite_curve.h>

#include <cmath>

namespace vug::field {
namespace {

constexpr int kPoints = 40;
constexpr double kSteepestApex = 1.4;  // Radians.

struct Stalagmite {
  double height = 1;
  double radius = 0.05;
  double landing = 0;
  double apex = 0;
  double root = 0;

  static void describe(Schema<Stalagmite>& s) {
    s.doc(
         "A stalagmite in its steady form, which stands on the origin along y: a candle, one with "
         "a flat top where drops scatter, or a cone under fast drips.")
        .cite("curl1973")
        .param("height", &Stalagmite::height, positive_length("height above the floor"))
        .param(
            "radius", &Stalagmite::radius,
            positive_length("radius of the trunk, which it approaches; in nature at least 1.5 cm"))
        .param("landing", &Stalagmite::landing,
               {.doc = "radius of the flat top within which drops land; it grows with the height "
                       "from which they fall, to some 5 cm at 20 m",
                .dimension = Dimension::length,
                .min = 0})
        .param("apex", &Stalagmite::apex,
               {.doc = "inclination of the apex: 0 for a candle, 45deg for a cone",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kSteepestApex})
        .param("root", &Stalagmite::root,
               {.doc = "length by which it continues downwards into the rock, so that it also "
                       "stands on a sloping floor",
                .dimension = Dimension::length,
                .min = 0});
  }
  StalagmiteForm form() const { return {radius, landing, maths::cos(apex)}; }
  std::string fault() const {
    if (!(landing < radius))
      return "the landing of a stalagmite must be smaller than the radius of its trunk";
    return StalagmiteCurve(form()).depth_at(landing) < height
               ? ""
               : "the cone of the apex is higher than the stalagmite; use a smaller 'landing' or "
                 "'apex'";
  }
  std::vector<Vec2d> outline() const {
    std::vector<Vec2d> out;
    for (const Vec2d& p : StalagmiteCurve(form()).points(height, kPoints))
      out.emplace_back(p.x, height - p.y);
    out.back().y = 0;
    if (root > 0) out.emplace_back(out.back().x, -root);
    out.emplace_back(0, -root);
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(stalagmite) {
  return field_kind<Stalagmite>("stalagmite", "primitive", [](const Stalagmite& s) {
    return lathe("stalagmite", s.outline());
  });
}
