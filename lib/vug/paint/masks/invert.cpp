// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Invert {
  Mask mask;

  static void describe(Schema<Invert>& s) {
    s.doc("1 where a mask is 0, 0 where it is 1.")
        .param("mask", &Invert::mask, {.doc = "the mask", .required = true});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(invert) {
  return mask_kind<Invert>("invert", [](const Invert& i) {
    return make_mask([i](const EvalPoint& point) { return 1 - (*i.mask)(point); }, i.mask->uses());
  });
}
