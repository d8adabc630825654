// SPDX-License-Identifier: Apache-2.0
// A trapezoid: a roof along a bed, and walls that lean.
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct Trapezoid {
  double roof = 0.6;
  double rounding = 0.1;

  static void describe(Schema<Trapezoid>& s) {
    s.doc("A trapezoid with a flat roof along a bed and leaning walls.")
        .param("roof", &Trapezoid::roof,
               section_fraction("width of the roof as a fraction of the width", 0.02, 1))
        .param("rounding", &Trapezoid::rounding,
               section_fraction("radius of the corners as a fraction of half the smaller size", 0,
                                0.5));
  }

  SectionPtr fit(const SectionPlace& place) const {
    const double a = 0.5 * place.width, b = 0.5 * place.height, top = roof * a;
    return polygon_section({{-a, -b}, {a, -b}, {top, b}, {-top, b}},
                           rounding * std::min({a, b, top}));
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(trapezoid) { return section_kind<Trapezoid>("trapezoid"); }
