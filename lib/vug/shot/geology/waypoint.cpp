// SPDX-License-Identifier: Apache-2.0
// A point through which a passage leads.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Waypoint {
  Vec3d at{0, 0, 0};

  static void describe(Schema<Waypoint>& s) {
    s.doc("A point through which a passage leads.").param("at", &Waypoint::at, position());
  }
  void add(karst::Geology& geology) const { geology.waypoints.push_back(at); }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(waypoint) { return geology_kind<Waypoint>("waypoint"); }
