// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Multiply {
  std::vector<Mask> of;

  static void describe(Schema<Multiply>& s) {
    s.doc("Product of masks.")
        .param("of", &Multiply::of, {.doc = "the masks, as a list", .required = true});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(multiply) {
  return mask_kind<Multiply>("multiply", [](const Multiply& m) {
    const auto evaluate = [m](const EvalPoint& point) {
      double product = 1;
      for (const Mask& mask : m.of) {
        if (product == 0) break;  // Masks are finite, so the others do not matter.
        product *= (*mask)(point);
      }
      return product;
    };
    return make_mask(evaluate, attribute_uses(m.of));
  });
}
