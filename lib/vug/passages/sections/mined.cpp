// SPDX-License-Identifier: Apache-2.0
// A mine gallery: vertical walls, a flat floor and an arched roof.
#include <vug/passages/polygon_section.h>

namespace vug::passages {
namespace {

struct Mined {
  double arch = 0.35;

  static void describe(Schema<Mined>& s) {
    s.doc("A mine gallery: vertical walls and an arched or flat roof.")
        .param("arch", &Mined::arch,
               section_fraction("rise of the arch as a fraction of the height; 0: a flat roof", 0,
                                0.9));
  }

  SectionPtr fit(const SectionPlace& place) const {
    const double a = 0.5 * place.width, b = 0.5 * place.height, rise = arch * place.height;
    std::vector<Vec2d> outline{{-a, -b}, {a, -b}};
    if (rise > 0)
      append_arc(outline, {0, b - rise}, {a, rise}, 0, kPi, 20);
    else
      outline.insert(outline.end(), {{a, b}, {-a, b}});
    return polygon_section(outline);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(mined) { return section_kind<Mined>("mined"); }
