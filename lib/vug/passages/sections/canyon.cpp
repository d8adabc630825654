// SPDX-License-Identifier: Apache-2.0
// The section of a vadose canyon: parallel walls around a centre line that migrates with depth. A
// stream that cuts down moves towards the outer bank of its bends, by a fraction of the depth that
// is proportional to the curvature and grows with the depth below the roof as the meanders do.
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct Canyon {
  double migration = 0.5;
  double ledges = 0.15;

  static void describe(Schema<Canyon>& s) {
    s.doc(
         "A canyon that a stream cut: tall, with parallel walls that migrate at bends and ledges "
         "where the "
         "stream paused.")
        .param("migration", &Canyon::migration,
               section_fraction(
                   "sideways shift of the floor as a fraction of the width where the radius of the "
                   "bend is 2.3 widths",
                   0, 3))
        .param("ledges", &Canyon::ledges,
               section_fraction("depth of the ledges in the walls as a fraction of the width", 0,
                                0.4));
  }

  SectionPtr fit(const SectionPlace& place) const {
    constexpr int kLevels = 10;
    const double w = place.width, h = place.height;
    // Meanders have a radius of about 2.3 widths; a bend to the left (positive) shifts to the
    // right.
    const double bend = std::clamp(place.curvature * 2.3 * w, -1.0, 1.0);
    std::vector<Vec2d> right, left;
    for (int i = 0; i <= kLevels; ++i) {
      const double v = h * (0.5 - static_cast<double>(i) / kLevels);
      // The axis stays within the walls: the shift is 0 at its height and grows both ways.
      const double depth = -v / h;
      const double shift = migration * bend * w * depth * (1 + depth);
      const double notch = i % 3 == 1 ? 1 - 2 * ledges : 1;
      right.push_back({shift + 0.5 * w * notch, v});
      left.push_back({shift - 0.5 * w * notch, v});
    }
    std::vector<Vec2d> outline(left);
    outline.insert(outline.end(), right.rbegin(), right.rend());
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(canyon) { return section_kind<Canyon>("canyon"); }
