// SPDX-License-Identifier: Apache-2.0
// One plane that water follows like a joint.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Fault {
  Vec3d at{0, 0, 0};
  double azimuth = 0;
  double dip = 0.5 * kPi;
  double width = 5;

  static void describe(Schema<Fault>& s) {
    s.doc("One plane that water follows like a joint, over its whole extent.")
        .param("at", &Fault::at, any_length("a point of the fault"))
        .param("azimuth", &Fault::azimuth, compass("direction of the fault"))
        .param("dip", &Fault::dip, dip_angle("steepness; 90deg: vertical", 0.5 * kPi))
        .param("width", &Fault::width, positive_length("distance over which it attracts water"));
  }
  void add(karst::Geology& geology) const {
    geology.faults.push_back({.point = at, .azimuth = azimuth, .dip = dip, .width = width});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(fault) { return geology_kind<Fault>("fault"); }
