// SPDX-License-Identifier: Apache-2.0
// A gypsum flower: bundles of fibres that grow at their feet. One side of a bundle grows faster, so
// it curls away from the middle like a petal.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/kind.h>
#include <vug/field/round_cone.h>
#include <vug/field/speleothems/element_field.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct GypsumFlower {
  static constexpr double kApart = 1.3;  // Radii between the fibres of a petal.
  static constexpr double kMostParts = 2e5;
  static constexpr int kSteps = 24;

  double length = 0.08;
  int petals = 6;
  double width = 0.012;
  double thickness = 0.003;
  double curl = 150 * kPi / 180;
  int seed = 1;

  static void describe(Schema<GypsumFlower>& s) {
    s.doc(
         "A gypsum flower, which grows from the origin along y: petals of parallel fibres that "
         "curl outwards.")
        .cite("hill1997")
        .param("length", &GypsumFlower::length,
               positive_length("mean length of a petal along its curve, 5 to 300 mm"))
        .param("petals", &GypsumFlower::petals, {.doc = "number of petals", .min = 1, .max = 60})
        .param("width", &GypsumFlower::width, positive_length("width of a petal"))
        .param("thickness", &GypsumFlower::thickness, positive_length("thickness of a petal"))
        .param("curl", &GypsumFlower::curl,
               {.doc = "angle by which the end of a petal is bent outwards",
                .dimension = Dimension::angle,
                .min = 0,
                .max = 2 * kPi})
        .param("seed", &GypsumFlower::seed, {.doc = "random seed; each seed gives another flower"});
  }
  std::string fault() const {
    if (!(thickness <= width)) return "a petal must be at most as thick as it is wide";
    if (!(thickness < 0.2 * length)) return "a petal must be thinner than a fifth of its length";
    return petals * kSteps * (1 + width / thickness) < kMostParts
               ? ""
               : "the petals are too wide for their thickness";
  }
  void petal(double turn, RandomStream& random, std::vector<RoundCone>& out) const {
    const double radius = 0.5 * thickness, size = length * random.uniform(0.6, 1.25);
    const double open = random.uniform(0.1, 0.5), bend = curl * random.uniform(0.7, 1.15);
    const Vec3d away(maths::cos(turn), 0, maths::sin(turn)), aside(-away.z, 0, away.x);
    const int fibres =
        std::max(1, static_cast<int>(std::lround((width - thickness) / (kApart * radius))) + 1);
    for (int f = 0; f < fibres; ++f) {
      const double across = (f - 0.5 * (fibres - 1)) * kApart * radius;
      const double reach = size * random.uniform(0.85, 1.0);  // Ends are ragged.
      Vec3d at = aside * across;
      for (int i = 0; i < kSteps; ++i) {
        const double part = (i + 0.5) / kSteps;
        const double angle = open + bend * part * part;
        const Vec3d next =
            at + (Vec3d(0, maths::cos(angle), 0) + away * maths::sin(angle)) * (reach / kSteps);
        out.push_back({at, next, radius, radius});
        at = next;
      }
    }
  }
  Field make() const {
    RandomStream random(RandomKey(static_cast<uint64_t>(seed)).at("gypsum_flower"));
    std::vector<RoundCone> fibres;
    for (int i = 0; i < petals; ++i)
      petal(2 * kPi * (i + 0.7 * random.uniform()) / petals, random, fibres);
    return element_field("gypsum_flower", std::move(fibres), Exactness::exact);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(gypsum_flower) {
  return field_kind<GypsumFlower>("gypsum_flower", "primitive",
                                  [](const GypsumFlower& g) { return g.make(); });
}
