// SPDX-License-Identifier: Apache-2.0
// A shield: water under pressure leaves a joint, and two plates grow on either side of the crack
// that continues it.
#include <vug/base/frames.h>
#include <vug/base/maths.h>
#include <vug/field/affine.h>
#include <vug/field/kind.h>
#include <vug/field/lathe.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct Shield {
  static constexpr int kMostRings = 40;
  static constexpr int kPointsPerRing = 6;

  double diameter = 1;
  double thickness = 0.04;
  double edge = 0.015;
  double crack = 0.001;
  double core = 0.15;
  double ring = 0.04;
  double relief = 0.003;
  Vec3d normal{0, 1, 0};

  static void describe(Schema<Shield>& s) {
    s.doc(
         "A shield (palette): two parallel round plates with a crack between them, about the "
         "origin on the plane of a joint. The rock covers one half of it.")
        .cite("hill1997")
        .param("diameter", &Shield::diameter,
               positive_length("diameter of the plates, 10 cm to 3 m in caves"))
        .param("thickness", &Shield::thickness,
               positive_length("thickness of a plate at its middle"))
        .param("edge", &Shield::edge, positive_length("thickness of a plate at its edge"))
        .param("crack", &Shield::crack,
               positive_length("width of the crack between the plates, 1 mm in caves; at least two "
                               "voxels in a level set that shows it"))
        .param("core", &Shield::core,
               {.doc = "radius within which the plates are joined, over that of the shield",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("ring", &Shield::ring, positive_length("width of a growth ring"))
        .param("relief", &Shield::relief,
               {.doc = "height of the growth rings", .dimension = Dimension::length, .min = 0})
        .param("normal", &Shield::normal, {.doc = "normal of the joint, of any length but 0"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal of the joint must not be zero";
    if (!(edge <= thickness)) return "the edge of a shield must be at most as thick as its middle";
    if (!(2 * relief < edge)) return "the relief of a shield must be below half of its edge";
    return edge < 0.5 * diameter ? ""
                                 : "the edge of a shield must be thinner than half its diameter";
  }
  /// Height of the outer face of a plate above the plane of the joint.
  double face(double r) const {
    const double part = r / (0.5 * diameter);
    const double plate = mix(thickness, edge, part * part);
    const int rings = std::clamp(static_cast<int>(0.5 * diameter / ring), 1, kMostRings);
    // Each ring is a new layer that bulges: cusped grooves between the rings.
    const double along = part * rings - std::floor(part * rings);
    return 0.5 * crack + plate - relief * (2 * along - 1) * (2 * along - 1);
  }
  std::vector<Vec2d> outline() const {
    const double radius = 0.5 * diameter;
    const int rings = std::clamp(static_cast<int>(radius / ring), 1, kMostRings);
    const int count = rings * kPointsPerRing;
    // The edge is round: the outer face ends where the half-circle of the edge begins.
    const double round = 0.5 * std::min(edge - relief, radius);
    std::vector<Vec2d> upper;
    for (int i = 0; i <= count; ++i) {
      const double r = (radius - round) * i / count;
      upper.emplace_back(r, face(r));
    }
    const double middle = 0.5 * (upper.back().y + 0.5 * crack);
    const double high = upper.back().y - middle;
    for (int i = 1; i <= 6; ++i) {
      const double angle = 0.5 * kPi - kPi * i / 6;
      upper.emplace_back(radius - round + round * maths::cos(angle),
                         middle + high * maths::sin(angle));
    }
    const double joined = core * (radius - round);
    upper.emplace_back(joined, 0.5 * crack);
    std::vector<Vec2d> out = upper;
    for (auto p = upper.rbegin(); p != upper.rend(); ++p) out.emplace_back(p->x, -p->y);
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(shield) {
  return field_kind<Shield>("shield", "primitive", [](const Shield& s) {
    const Field plates = lathe("shield", s.outline());
    const Vec3d up(0, 1, 0), to = s.normal.normalized();
    return (to - up).length() < 1e-12 ? plates : transformed(plates, rotation_between(up, to));
  });
}
