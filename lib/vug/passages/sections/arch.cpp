// SPDX-License-Identifier: Apache-2.0
// A breakdown arch: beds fell from the roof, each with a narrower span than the bed below, because
// the broken ends stay as ledges; the beam theory of speleology gives the span that a bed still
// bears.
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct Arch {
  double wall = 0.35;
  double span = 0.35;
  double bed = 0.5;

  static void describe(Schema<Arch>& s) {
    s.doc("A breakdown arch: walls below a vault of beds, each of which leaves a ledge.")
        .param("wall", &Arch::wall,
               section_fraction("height of the walls as a fraction of the height", 0.05, 0.9))
        .param("span", &Arch::span,
               section_fraction(
                   "span of the bed that still bears, the roof, as a fraction of the width", 0.05,
                   0.95))
        .param("bed", &Arch::bed, positive_length("thickness of a bed"));
  }
  SectionPtr fit(const SectionPlace& place) const {
    const double a = 0.5 * place.width, h = place.height, spring = (wall - 0.5) * h;
    const double rise = (1 - wall) * h;
    const int beds = std::clamp(static_cast<int>(std::lround(rise / bed)), 2, 12);
    std::vector<Vec2d> outline{{-a, -0.5 * h}, {a, -0.5 * h}};
    const auto half_span = [&](int i) {  // Of the void in bed i, on an ellipse from wall to roof.
      const double t = static_cast<double>(i) / beds;
      return a * std::max(span, std::sqrt(1 - (1 - span * span) * t * t));
    };
    for (int i = 0; i < beds; ++i) {
      outline.push_back({half_span(i), spring + rise * i / beds});
      outline.push_back({half_span(i), spring + rise * (i + 1) / beds});
    }
    for (int i = beds - 1; i >= 0; --i) {
      outline.push_back({-half_span(i), spring + rise * (i + 1) / beds});
      outline.push_back({-half_span(i), spring + rise * i / beds});
    }
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(arch) { return section_kind<Arch>("arch"); }
