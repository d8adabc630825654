// SPDX-License-Identifier: Apache-2.0
// A dome of travertine below a spring or a heavy drip: a film of laminar water that thins as it
// spreads and speeds up as the dome steepens (goldenfeld2006).
#include <vug/base/maths.h>
#include <vug/field/kind.h>
#include <vug/field/lathe.h>
#include <vug/field/speleothems/dome_curve.h>

namespace vug::field {
namespace {

struct TravertineDome {
  static constexpr int kCurvePoints = 48;

  double radius = 0.5;
  double slope = 70 * kPi / 180;
  double root = 0.1;

  static void describe(Schema<TravertineDome>& s) {
    s.doc(
         "A dome of travertine, flat on top and steeper towards its foot, which is a circle about "
         "the origin.")
        .cite("goldenfeld2006")
        .param("radius", &TravertineDome::radius, positive_length("radius of the foot"))
        .param("slope", &TravertineDome::slope,
               {.doc = "slope of the surface at the foot: a higher dome is steeper there",
                .dimension = Dimension::angle,
                .min = 5 * kPi / 180,
                .max = 85 * kPi / 180})
        .param("root", &TravertineDome::root,
               {.doc = "length by which it continues downwards into the ground",
                .dimension = Dimension::length,
                .min = 0});
  }
  std::vector<Vec2d> outline() const {
    const std::vector<Vec2d> side = dome_points(radius, slope, kCurvePoints);
    std::vector<Vec2d> out = {Vec2d(0, -root)};
    if (root > 0) out.emplace_back(radius, -root);
    out.insert(out.end(), side.begin(), side.end());
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(travertine_dome) {
  return field_kind<TravertineDome>("travertine_dome", "primitive", [](const TravertineDome& d) {
    return lathe("travertine_dome", d.outline());
  });
}
