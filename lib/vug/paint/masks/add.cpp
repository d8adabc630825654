// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Add {
  std::vector<Mask> of;

  static void describe(Schema<Add>& s) {
    s.doc("Sum of masks; above 1 where they overlap.")
        .param("of", &Add::of, {.doc = "the masks, as a list", .required = true});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(add) {
  return mask_kind<Add>("add", [](const Add& a) {
    const auto evaluate = [a](const EvalPoint& point) {
      double sum = 0;
      for (const Mask& mask : a.of) sum += (*mask)(point);
      return sum;
    };
    return make_mask(evaluate, attribute_uses(a.of));
  });
}
