// SPDX-License-Identifier: Apache-2.0
// Weathered rock that passages follow.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct GhostRock {
  field::Field inside;

  static void describe(Schema<GhostRock>& s) {
    s.doc("Weathered rock (ghost rock), which is easily washed out: passages follow it.")
        .param("field", &GhostRock::inside, {.doc = "the weathered part", .required = true});
  }
  void add(karst::Geology& geology) const { geology.ghost_rock.push_back(inside); }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(ghost_rock) { return geology_kind<GhostRock>("ghost_rock"); }
