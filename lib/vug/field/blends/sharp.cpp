// SPDX-License-Identifier: Apache-2.0
#include <vug/field/blend_kind.h>

namespace vug::field {
namespace {

struct Sharp {
  static void describe(Schema<Sharp>& s) {
    s.doc("A sharp crease: the operands keep their values.");
  }
};

}  // namespace
}  // namespace vug::field

VUG_BLEND_KIND(sharp) {
  return blend_kind<Sharp>("sharp", [](const Sharp&) { return Blend{}; });
}
