// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/affine.h>
#include <vug/field/registry.h>
#include <vug/field/speleogens/roofs.h>

#include <algorithm>

namespace vug::field {
namespace {

constexpr double kSpread = 0.35;  // Of the logarithm of diameters: a factor of 1.42 either way.

struct Cupolas : RoofHollows {
  double diameter = 1.8;
  double rise = 0.8;

  void add_to(Digester& digester) const {
    digester(static_cast<const RoofHollows&>(*this), diameter, rise);
  }

  static void describe(Schema<Cupolas>& s) {
    s.doc(
         "Cupolas: domes that slowly moving water or condensation dissolved into the roof of a "
         "cave. Domes that grew together meet in sharp cusps, across all beds.")
        .cite("osborne2004");
    describe_roof_hollows(s);
    s.param("diameter", &Cupolas::diameter,
            positive_length("mean diameter, 50 cm to 10 m in caves"))
        .param("rise", &Cupolas::rise,
               {.doc = "height of a cupola over half of its diameter; 1 for half-spheres",
                .dimension = Dimension::ratio,
                .min = 0.2,
                .max = 3});
  }

  Field hollow(const Roof& roof) const {
    const double radius = 0.5 * diameter * maths::exp(kSpread * (2 * roof.random[0] - 1));
    const double height = radius * rise * (0.8 + 0.4 * roof.random[1]);
    // The lower half hangs in the air of the cave, but leaves its floor as it is.
    const double low = std::min(height, 0.5 * roof.clearance);
    const double centre = 0.5 * (height - low);
    return transformed(make("ellipsoid", {{"radii", Vec3d(radius, 0.5 * (height + low), radius)}}),
                       Transform::translation(roof.at + Vec3d(0, centre, 0)));
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(cupolas) {
  return field_kind<Cupolas>("cupolas", "detail", [](const Cupolas& c) {
    return hollowed(c, 0.75 * c.diameter * std::max(1.0, 1.2 * c.rise));
  });
}
