// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/paint/kind.h>
#include <vug/paint/space.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Facing : InSpace {
  Vec3d toward{0, 0, 1};
  double from = kPi / 2;
  double to = 0;
  std::string fault() const {
    return toward.length2() > 0 ? "" : "a direction must be longer than 0";
  }

  static void describe(Schema<Facing>& s) {
    s.doc("1 where the surface faces a direction: its weather side, its lee side.")
        .param("toward", &Facing::toward, {.doc = "a direction, of any length"})
        .param("from", &Facing::from,
               {.doc = "angle between the direction and the normal where the mask is 0",
                .dimension = Dimension::angle})
        .param("to", &Facing::to,
               {.doc = "angle where the mask is 1", .dimension = Dimension::angle});
    describe_space(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(facing) {
  return mask_kind<Facing>("facing", [](const Facing& f) {
    const auto evaluate = [f, way = f.toward.normalized()](const EvalPoint& point) {
      const double along = std::clamp(point.normal.dot(way), -1.0, 1.0);
      return ramp(maths::acos(along), f.from, f.to);
    };
    return make_mask(in_space(f, evaluate), f.uses());
  });
}
