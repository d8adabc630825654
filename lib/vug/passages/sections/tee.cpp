// SPDX-License-Identifier: Apache-2.0
// A T: a slot along a bedding plane above a canyon.
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct Tee {
  double slab = 0.2;
  double stem = 0.3;
  double rounding = 0.5;

  static void describe(Schema<Tee>& s) {
    s.doc("A T: a low wide slot with a canyon below.")
        .param("slab", &Tee::slab,
               section_fraction("height of the upper slot as a fraction of the height", 0.05, 0.45))
        .param("stem", &Tee::stem,
               section_fraction("width of the canyon as a fraction of the width", 0.05, 0.95))
        .param("rounding", &Tee::rounding,
               section_fraction("radius of the corners as a fraction of half the narrower part", 0,
                                0.9));
  }

  SectionPtr fit(const SectionPlace& place) const {
    const double a = 0.5 * place.width, b = 0.5 * place.height;
    const double half = stem * a, under = b - slab * place.height;
    const double narrow = std::min(half, 0.5 * slab * place.height);
    return polygon_section({{-a, b},
                            {-a, under},
                            {-half, under},
                            {-half, -b},
                            {half, -b},
                            {half, under},
                            {a, under},
                            {a, b}},
                           std::min(rounding * narrow, 0.9 * (a - half)));
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(tee) { return section_kind<Tee>("tee"); }
