// SPDX-License-Identifier: Apache-2.0
// Hoar: plates of ice that grow on the cold roof and walls of an ice cave, towards the moist air.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/hex_plate.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Hoar : SurfaceScatter {
  double diameter = 0.02;
  double thickness = 0.0008;
  double tilt = 35 * kPi / 180;
  Vec3d wind{0, 0, 0};

  Hoar() { spacing = 0.012; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), diameter, thickness, tilt, wind);
  }

  static void describe(Schema<Hoar>& s) {
    s.doc("Hoar: thin hexagonal plates of ice that stand on a cold surface.");
    describe_surface_scatter(s)
        .param("diameter", &Hoar::diameter,
               positive_length("mean diameter of a plate, some millimetres to 10 cm"))
        .param("thickness", &Hoar::thickness,
               positive_length("thickness of a plate; at least two voxels in a level set"))
        .param("tilt", &Hoar::tilt,
               {.doc = "largest angle between a plate and the normal of the surface",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi / 2})
        .param("wind", &Hoar::wind,
               {.doc = "direction of a draught of moist air: plates are larger on the side that it "
                       "meets; zero: still air"});
  }
  std::string fault() const {
    if (!(thickness < 0.5 * diameter)) return "a plate must be thinner than half of its diameter";
    return SurfaceScatter::fault();
  }
  double reach() const { return 3 * diameter + thickness; }

  Field plates() const {
    std::vector<HexPlate> out;
    for (const SurfacePlace& place : find_surface_places(*this)) {
      RandomStream random(place.key);
      double size = 0.5 * diameter * log_uniform(random, 0.4);
      if (wind.length2() > 0) size *= 0.65 - 0.6 * place.normal.dot(wind.normalized());
      const double turn = 2 * kPi * random.uniform(), angle = tilt * random.uniform(-1, 1);
      // Up the plate, and across it along the surface.
      const Vec3d up = tilted(place.normal, angle, turn);
      const Vec3d across = tilted(place.normal, kPi / 2, turn + kPi / 2);
      const Vec3d centre = place.at + up * (0.7 * size);
      if (size > 2 * thickness)
        out.emplace_back(centre, across.cross(up).normalized(), up, size, 0.5 * thickness);
    }
    return element_field("hoar", std::move(out), Exactness::bound);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(hoar) {
  return field_kind<Hoar>("hoar", "detail", [](const Hoar& h) {
    return unite({h.field, deferred(
                               surface_traits(h, h.reach()), {"growing hoar", h.bytes<HexPlate>()},
                               [](const Hoar& each) { return each.plates(); }, h)});
  });
}
