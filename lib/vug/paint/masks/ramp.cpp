// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Ramp {
  Mask mask;
  double from = 0;
  double to = 1;

  static void describe(Schema<Ramp>& s) {
    s.doc(
         "Stretches a mask: 0 up to one value of it, 1 from another on, smooth between; a step if "
         "both are the same.")
        .param("mask", &Ramp::mask, {.doc = "the mask", .required = true})
        .param("from", &Ramp::from, {.doc = "its value where the result is 0"})
        .param("to", &Ramp::to,
               {.doc = "its value where the result is 1; if less than from, the ramp descends"});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(ramp) {
  return mask_kind<Ramp>("ramp", [](const Ramp& r) {
    return make_mask([r](const EvalPoint& point) { return ramp((*r.mask)(point), r.from, r.to); },
                     r.mask->uses());
  });
}
