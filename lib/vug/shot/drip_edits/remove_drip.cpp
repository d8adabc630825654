// SPDX-License-Identifier: Apache-2.0
// A drip that was removed by hand.
#include <vug/shot/drip_edits.h>

namespace vug::shot {
namespace {

struct RemoveDrip {
  int drip = 0;

  static void describe(Schema<RemoveDrip>& s) {
    s.doc("Removes a drip with all that grows from its water.")
        .param("drip", &RemoveDrip::drip,
               {.doc = "its number, as 'vug drips' prints it", .min = 0, .required = true});
  }
  void add(drips::DripEdits& edits, const SourceLocation& where) const {
    edits.removed.push_back({drip, where});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_DRIP_EDIT_KIND(remove_drip) { return drip_edit_kind<RemoveDrip>("remove_drip"); }
