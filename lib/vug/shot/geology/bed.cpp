// SPDX-License-Identifier: Apache-2.0
// A bedding plane along which passages begin to form.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct InceptionHorizon {
  Vec3d at{0, 0, 0};
  double dip = 0;
  double towards = 0;

  static void describe(Schema<InceptionHorizon>& s) {
    s.doc("A bedding plane along which passages begin to form (an inception horizon).")
        .param("at", &InceptionHorizon::at, any_length("a point of the plane"))
        .param("dip", &InceptionHorizon::dip, dip_angle("steepness of the plane", 1.5))
        .param("towards", &InceptionHorizon::towards, compass("direction in which it falls"));
  }
  void add(karst::Geology& geology) const {
    geology.beds.push_back({.point = at, .dip = dip, .dip_azimuth = towards});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(bed) { return geology_kind<InceptionHorizon>("bed"); }
