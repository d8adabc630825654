// SPDX-License-Identifier: Apache-2.0
#include <vug/field/value_below.h>
#include <vug/paint/kind.h>
#include <vug/paint/space.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Near : InSpace {
  field::Field field;
  double from = 1;
  double to = 0;

  static void describe(Schema<Near>& s) {
    s.doc(
         "0 at one distance to another solid, 1 at another: stains under a lamp, wet rock around a "
         "pool.")
        .param("field", &Near::field, {.doc = "the solid", .required = true})
        .param("from", &Near::from, any_length("distance where the mask is 0"))
        .param("to", &Near::to, any_length("distance where the mask is 1"));
    describe_space(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(near) {
  return mask_kind<Near>("near", [](const Near& n) {
    const auto evaluate = [n](const EvalPoint& point) {
      // Beyond both distances the mask is constant.
      const double distance =
          field::value_below(*n.field.node(), field::point(point.position), std::max(n.from, n.to));
      return ramp(distance, n.from, n.to);
    };
    return make_mask(in_space(n, evaluate), n.uses());
  });
}
