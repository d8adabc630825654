// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Between {
  Mask mask;
  double from = 0;
  double to = 1;

  static void describe(Schema<Between>& s) {
    s.doc("A number that a mask drives from one value to another: a roughness, an index.")
        .param("mask", &Between::mask, {.doc = "the driving mask", .required = true})
        .param("from", &Between::from, {.doc = "the number where the mask is 0"})
        .param("to", &Between::to, {.doc = "the number where it is 1"});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(between) {
  return mask_kind<Between>("between", [](const Between& b) {
    return make_mask(
        [b](const EvalPoint& point) { return b.from + (b.to - b.from) * (*b.mask)(point); },
        b.mask->uses());
  });
}
