// SPDX-License-Identifier: Apache-2.0
// A drip that was added by hand.
#include <vug/shot/drip_edits.h>

namespace vug::shot {
namespace {

struct AddDrip {
  Vec3d at{0, 0, 0};
  double interval = 60;
  double age = 1000;

  static void describe(Schema<AddDrip>& s) {
    s.doc(
         "Water also drips from the roof above a point. The drips that are added have the numbers "
         "-1, -2, ...")
        .param("at", &AddDrip::at,
               {.doc = "a point in the air below the roof",
                .dimension = Dimension::length,
                .required = true})
        .param("interval", &AddDrip::interval,
               {.doc = "time between two drops in seconds", .min = 0.5, .max = 1e6})
        .param("age", &AddDrip::age,
               {.doc = "years for which it has dripped, at most the age of the oldest drips",
                .min = 1,
                .max = 1e7});
  }
  void add(drips::DripEdits& edits, const SourceLocation& where) const {
    edits.added.push_back({at, interval, age, where});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_DRIP_EDIT_KIND(add_drip) { return drip_edit_kind<AddDrip>("add_drip"); }
