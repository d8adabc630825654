// SPDX-License-Identifier: Apache-2.0
// Where water leaves the rock.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct Spring {
  Vec3d at{0, 0, 0};
  int tier = 0;
  std::string name;

  static void describe(Schema<Spring>& s) {
    s.doc("Where water leaves the rock.")
        .param("at", &Spring::at, position())
        .param("tier", &Spring::tier,
               {.doc = "the water table in whose time it was active; 0: the present", .min = 0})
        .param("name", &Spring::name, {.doc = "name of its station"});
  }
  void add(karst::Geology& geology) const {
    geology.springs.push_back({.position = at, .tier = tier, .name = name});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(spring) { return geology_kind<Spring>("spring"); }
