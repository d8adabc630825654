// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>
#include <vug/paint/space.h>

namespace vug::paint {
namespace {

struct Height : InSpace {
  double from = 0;
  double to = 1;

  static void describe(Schema<Height>& s) {
    s.doc("0 at one height above the scene's origin, 1 at another.")
        .param("from", &Height::from, any_length("height where the mask is 0"))
        .param("to", &Height::to, any_length("height where the mask is 1"));
    describe_space(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(height) {
  return mask_kind<Height>("height", [](const Height& h) {
    const auto evaluate = [h](const EvalPoint& point) {
      return ramp(point.position.y, h.from, h.to);
    };
    return make_mask(in_space(h, evaluate), h.uses());
  });
}
