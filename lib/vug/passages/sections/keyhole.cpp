// SPDX-License-Identifier: Apache-2.0
// A keyhole: a tube that formed below the water table, and a canyon that a stream cut into its
// floor when the water table fell.
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct Keyhole {
  double tube = 0.45;
  double slot = 0.35;
  double shift = 0;

  static void describe(Schema<Keyhole>& s) {
    s.doc("A tube with a canyon in its floor.")
        .param("tube", &Keyhole::tube,
               section_fraction("height of the tube as a fraction of the height", 0.1, 0.9))
        .param("slot", &Keyhole::slot,
               section_fraction("width of the canyon as a fraction of the width of the tube", 0.1,
                                0.9))
        .param("shift", &Keyhole::shift,
               section_fraction("sideways shift of the canyon's floor as a fraction of the width",
                                -1, 1));
  }

  SectionPtr fit(const SectionPlace& place) const {
    const double h = place.height;
    const Vec2d radii(0.5 * place.width, 0.5 * tube * h);
    const Vec2d centre(0, 0.5 * h - radii.y);
    const double half = slot * radii.x, gap = maths::acos(slot);  // From the u axis to the canyon.
    std::vector<Vec2d> outline;
    append_arc(outline, centre, radii, -gap, kPi + gap, 28);
    // The canyon turns aside below the axis only, which therefore stays between its walls.
    const double top = std::min(0.0, outline.back().y - 0.02 * h), bottom = -0.5 * h;
    const double aside = shift * place.width;
    for (int i = 0; i <= 5; ++i) {
      const double t = i / 5.0;
      outline.push_back({-half + aside * t * t, top + (bottom - top) * t});
    }
    for (int i = 5; i >= 0; --i) {
      const double t = i / 5.0;
      outline.push_back({half + aside * t * t, top + (bottom - top) * t});
    }
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(keyhole) { return section_kind<Keyhole>("keyhole"); }
