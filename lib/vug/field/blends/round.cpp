// SPDX-License-Identifier: Apache-2.0
#include <vug/field/blend_kind.h>

namespace vug::field {
namespace {

struct Round {
  double radius = 0.2;

  static void describe(Schema<Round>& s) {
    s.doc("A circular fillet between faces at a right angle.")
        .param("radius", &Round::radius, positive_length("radius of the fillet"));
  }
};

}  // namespace
}  // namespace vug::field

VUG_BLEND_KIND(round) {
  return blend_kind<Round>("round", [](const Round& b) { return Blend{Profile::round, b.radius}; });
}
