// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/kind.h>
#include <vug/field/lathe.h>
#include <vug/field/speleothems/stalactite_curve.h>

#include <cmath>

namespace vug::field {
namespace {

constexpr int kCurvePoints = 40;
constexpr int kCapPoints = 8;

struct Stalactite {
  double length = 1;
  double radius = 0.1;
  double tip = 0.00255;
  double root = 0;

  static void describe(Schema<Stalactite>& s) {
    ParamSpec above{
        .doc =
            "length by which it continues upwards into the rock, so that it also meets a "
            "sloping roof",
        .dimension = Dimension::length,
        .min = 0};
    s.doc(
         "A stalactite in its ideal form, hanging from the origin along -y. Below its end is the "
         "cap of a drop. Short and wide ones have a blunt end.")
        .cite("short2005")
        .param("length", &Stalactite::length, positive_length("length above the cap of its end"))
        .param("radius", &Stalactite::radius, positive_length("radius at the roof"))
        .param("tip", &Stalactite::tip,
               positive_length("radius of its end: half the diameter of a soda straw, 2.55 mm; at "
                               "least a voxel in a level set"))
        .param("root", &Stalactite::root, above);
  }
  std::string fault() const {
    return tip < radius ? "" : "the tip of a stalactite must be thinner than its root";
  }
  std::vector<Vec2d> outline() const {
    const StalactiteCurve curve = StalactiteCurve::fit(radius, length, tip);
    const std::vector<Vec2d> side = curve.points(tip, radius, kCurvePoints);
    const double rim = side.front().x;
    std::vector<Vec2d> out;
    // A part of a sphere that continues the slope of the rim.
    const double slope = maths::atan2(curve.slope_at(rim), 1), ball = rim / maths::sin(slope);
    for (int i = 0; i < kCapPoints; ++i) {
      const double angle = slope * i / kCapPoints;
      out.emplace_back(ball * maths::sin(angle),
                       -length + ball * (maths::cos(slope) - maths::cos(angle)));
    }
    for (const Vec2d& p : side) out.emplace_back(p.x, p.y - length);
    out.back() = Vec2d(radius, 0);
    if (root > 0) out.emplace_back(radius, root);
    out.emplace_back(0, root);
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(stalactite) {
  return field_kind<Stalactite>("stalactite", "primitive", [](const Stalactite& s) {
    return lathe("stalactite", s.outline());
  });
}
