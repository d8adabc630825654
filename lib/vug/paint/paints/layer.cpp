// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Layer {
  Paint under;
  Paint over;
  Mask mask;

  static void describe(Schema<Layer>& s) {
    s.doc("One paint over another, blended by a mask.")
        .param(
            "under", &Layer::under,
            {.doc = "the lower paint: a paint or a colour", .min = 0, .max = 1, .required = true})
        .param("over", &Layer::over,
               {.doc = "the upper paint", .min = 0, .max = 1, .required = true})
        .param("mask", &Layer::mask, {.doc = "0 shows under, 1 shows over", .required = true});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_PAINT_KIND(layer) {
  return paint_kind<Layer>("layer", [](const Layer& l) {
    const auto evaluate = [l](const EvalPoint& point) {
      const double t = (*l.mask)(point);
      if (t <= 0) return (*l.under)(point);
      const Vec3d over = (*l.over)(point);
      return t >= 1 ? over : (*l.under)(point) * (1 - t) + over * t;
    };
    return make_paint(evaluate, attribute_uses(l.mask, l.under, l.over));
  });
}
