// SPDX-License-Identifier: Apache-2.0
// A half-tube: the upper half of an ellipse above a flat floor.
#include <vug/passages/polygon_section.h>

namespace vug::passages {
namespace {

struct HalfTube {
  static void describe(Schema<HalfTube>& s) {
    s.doc("A half-tube: an elliptic roof on a flat floor, which a bed or old sediment formed.");
  }
  SectionPtr fit(const SectionPlace& place) const {
    std::vector<Vec2d> outline;
    append_arc(outline, {0, -0.5 * place.height}, {0.5 * place.width, place.height}, 0, kPi, 32);
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(half_tube) { return section_kind<HalfTube>("half_tube"); }
