// SPDX-License-Identifier: Apache-2.0
// A lava tube: a vault that froze over a stream of lava, with benches that mark a lower level and a
// floor that solidified last.
#include <vug/passages/polygon_section.h>

namespace vug::passages {
namespace {

struct LavaTube {
  double bench = 0.12;
  double level = 0.2;

  static void describe(Schema<LavaTube>& s) {
    s.doc("A lava tube: an arched roof, benches along both walls and a flat floor.")
        .param("bench", &LavaTube::bench,
               section_fraction("width of a bench as a fraction of the width", 0, 0.3))
        .param("level", &LavaTube::level,
               section_fraction("height of the benches as a fraction of the height", 0.05, 0.45));
  }

  SectionPtr fit(const SectionPlace& place) const {
    const double a = 0.5 * place.width, h = place.height, top = level * h - 0.5 * h;
    const double channel = a * (1 - 2 * bench);
    std::vector<Vec2d> outline{{-channel, -0.5 * h}, {channel, -0.5 * h}};
    if (bench > 0) outline.push_back({channel, top});
    append_arc(outline, {0, top}, {a, h - level * h}, 0, kPi, 28);
    if (bench > 0) outline.push_back({-channel, top});
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(lava_tube) { return section_kind<LavaTube>("lava_tube"); }
