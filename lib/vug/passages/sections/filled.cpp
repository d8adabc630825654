// SPDX-License-Identifier: Apache-2.0
// A tube whose lower part is filled with sediment to a flat floor.
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct Filled {
  double fill = 0.35;

  static void describe(Schema<Filled>& s) {
    s.doc("A tube with a flat floor of sediment. Width and height are those of the open part.")
        .param("fill", &Filled::fill,
               section_fraction("height of the sediment as a fraction of the height of the tube",
                                0.02, 0.9));
  }

  SectionPtr fit(const SectionPlace& place) const {
    // The ellipse whose open part has the given height, and the given width at its widest.
    const double b = 0.5 * place.height / (1 - fill), floor = b * (2 * fill - 1);
    const double half = fill > 0.5 ? std::sqrt(1 - (floor / b) * (floor / b)) : 1;
    const double from = maths::atan2(floor / b, std::sqrt(1 - (floor / b) * (floor / b)));
    std::vector<Vec2d> outline;
    append_arc(outline, {0, -floor - 0.5 * place.height}, {0.5 * place.width / half, b}, from,
               kPi - from, 32);
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(filled) { return section_kind<Filled>("filled"); }
