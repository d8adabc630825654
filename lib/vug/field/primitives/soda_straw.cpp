// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/field/lathe.h>

namespace vug::field {
namespace {

struct SodaStraw {
  double length = 0.4;
  double radius = 0.00255;
  double wall = 0.0003;
  double root = 0;

  static void describe(Schema<SodaStraw>& s) {
    s.doc(
         "A soda straw: a tube of calcite as wide as the drops that hang from it, along -y from "
         "the origin.")
        .cite("curl1973")
        .param("length", &SodaStraw::length, positive_length("length below the roof"))
        .param("radius", &SodaStraw::radius,
               positive_length("outer radius; drops give nearly all straws the diameter of 5.1 mm"))
        .param("wall", &SodaStraw::wall,
               positive_length("thickness of the wall, less than the radius for an open tube; "
                               "thicker straws are solid"))
        .param("root", &SodaStraw::root,
               {.doc = "length by which it continues upwards into the rock",
                .dimension = Dimension::length,
                .min = 0});
  }
  std::vector<Vec2d> outline() const {
    const double bore = wall < radius ? radius - wall : 0;
    return {{bore, -length}, {radius, -length}, {radius, root}, {bore, root}};
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(soda_straw) {
  return field_kind<SodaStraw>("soda_straw", "primitive",
                               [](const SodaStraw& s) { return lathe("soda_straw", s.outline()); });
}
