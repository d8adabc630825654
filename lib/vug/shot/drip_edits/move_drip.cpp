// SPDX-License-Identifier: Apache-2.0
// A drip that was moved by hand.
#include <vug/shot/drip_edits.h>

namespace vug::shot {
namespace {

struct MoveDrip {
  int drip = 0;
  Vec3d to{0, 0, 0};

  static void describe(Schema<MoveDrip>& s) {
    s.doc("Moves a drip to the roof above a point. Its water and age stay the same.")
        .param("drip", &MoveDrip::drip,
               {.doc = "its number, as 'vug drips' prints it", .min = 0, .required = true})
        .param("to", &MoveDrip::to,
               {.doc = "a point in the air below the roof",
                .dimension = Dimension::length,
                .required = true});
  }
  void add(drips::DripEdits& edits, const SourceLocation& where) const {
    edits.moved.push_back({drip, to, where});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_DRIP_EDIT_KIND(move_drip) { return drip_edit_kind<MoveDrip>("move_drip"); }
