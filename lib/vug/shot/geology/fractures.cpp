// SPDX-License-Identifier: Apache-2.0
// A family of parallel joints.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Fractures {
  double azimuth = 0;
  double dip = 0.5 * kPi;
  double spacing = 20;
  double spread = 0.15;

  static void describe(Schema<Fractures>& s) {
    s.doc("A family of parallel joints, along which passages run.")
        .param("azimuth", &Fractures::azimuth, compass("direction of the joints"))
        .param("dip", &Fractures::dip, dip_angle("steepness; 90deg: vertical", 0.5 * kPi))
        .param("spacing", &Fractures::spacing, positive_length("mean distance between two joints"))
        .param("spread", &Fractures::spread,
               {.doc = "standard deviation of the directions",
                .dimension = Dimension::angle,
                .min = 0,
                .max = 1.5,
                .above_min = true});
  }
  void add(karst::Geology& geology) const {
    geology.fractures.push_back(
        {.azimuth = azimuth, .dip = dip, .spacing = spacing, .spread = spread});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(fractures) { return geology_kind<Fractures>("fractures"); }
