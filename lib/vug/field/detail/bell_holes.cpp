// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/registry.h>
#include <vug/field/speleogens/roofs.h>

#include <algorithm>

namespace vug::field {
namespace {

struct BellHoles : RoofHollows {
  double diameter = 0.6;
  double height = 1.2;

  void add_to(Digester& digester) const {
    digester(static_cast<const RoofHollows&>(*this), diameter, height);
  }

  static void describe(Schema<BellHoles>& s) {
    s.doc(
         "Bell holes: plumb round shafts that end blindly in the roof of a cave, with a dome on "
         "top. They are vertical whatever the slope of the roof.")
        .cite("osborne2004");
    describe_roof_hollows(s);
    s.param("diameter", &BellHoles::diameter,
            positive_length("mean diameter, 30 cm to 1 m in caves"))
        .param("height", &BellHoles::height, positive_length("mean height above the roof"));
  }

  Field hollow(const Roof& roof) const {
    const double radius = 0.5 * diameter * (0.7 + 0.6 * roof.random[0]);
    const double top = std::max(height * (0.4 + 1.2 * roof.random[1]), radius);
    // The mouth reaches below a sloping roof, but not to the floor.
    const double mouth = std::min(radius, 0.3 * roof.clearance);
    return make("capsule", {{"a", roof.at + Vec3d(0, radius - mouth, 0)},
                            {"b", roof.at + Vec3d(0, std::max(top - radius, radius - mouth), 0)},
                            {"radius", radius}});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(bell_holes) {
  return field_kind<BellHoles>("bell_holes", "detail", [](const BellHoles& b) {
    return hollowed(b, 1.6 * b.height + b.diameter);
  });
}
