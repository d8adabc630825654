// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/paint/kind.h>
#include <vug/paint/space.h>

namespace vug::paint {
namespace {

struct Slope : InSpace {
  double from = 0;
  double to = kPi;

  static void describe(Schema<Slope>& s) {
    s.doc(
         "0 at one angle between the surface's normal and up, 1 at another; the angle is 0 on "
         "floors, "
         "90deg on walls and 180deg on ceilings.")
        .param("from", &Slope::from,
               {.doc = "angle where the mask is 0", .dimension = Dimension::angle})
        .param("to", &Slope::to,
               {.doc = "angle where the mask is 1", .dimension = Dimension::angle});
    describe_space(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(slope) {
  return mask_kind<Slope>("slope", [](const Slope& s) {
    const auto evaluate = [s](const EvalPoint& point) {
      return ramp(maths::acos(point.normal.y), s.from, s.to);
    };
    return make_mask(in_space(s, evaluate), s.uses());
  });
}
