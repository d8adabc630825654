// SPDX-License-Identifier: Apache-2.0
// A dry entrance, to which a passage leads.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Entrance {
  Vec3d at{0, 0, 0};

  static void describe(Schema<Entrance>& s) {
    s.doc("A dry entrance, to which a passage leads.").param("at", &Entrance::at, position());
  }
  void add(karst::Geology& geology) const { geology.entrances.push_back(at); }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(entrance) { return geology_kind<Entrance>("entrance"); }
