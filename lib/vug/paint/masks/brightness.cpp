// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct Brightness {
  Paint paint;
  double from = 0;
  double to = 1;

  static void describe(Schema<Brightness>& s) {
    s.doc("0 at one luminance of a paint, such as a picture, 1 at another.")
        .param("paint", &Brightness::paint, {.doc = "the paint", .required = true})
        .param("from", &Brightness::from, {.doc = "luminance where the mask is 0"})
        .param("to", &Brightness::to, {.doc = "luminance where the mask is 1"});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(brightness) {
  return mask_kind<Brightness>("brightness", [](const Brightness& b) {
    const auto evaluate = [b](const EvalPoint& point) {
      const Vec3d rgb = (*b.paint)(point);
      return ramp(0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z, b.from, b.to);
    };
    return make_mask(evaluate, b.paint->uses());
  });
}
