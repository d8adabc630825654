// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Band {
  double projection = 0.08;
  double past = 0;
  double rounding = 0.01;

  static void describe(Schema<Band>& s) {
    s.doc(
         "A straight ledge of the height of its rectangle: a string course, a step, a lintel, a "
         "sill.")
        .param("projection", &Band::projection, positive_length("projection of the ledge"))
        .param("past", &Band::past,
               {.doc = "overhang at both ends", .dimension = Dimension::length, .min = 0})
        .param("rounding", &Band::rounding,
               {.doc = "radius of the edges", .dimension = Dimension::length, .min = 0});
  }

  Solids solids(double width, double height) const {
    Solids out;
    out.add.push_back(block({-past, 0, width + 2 * past, height}, -0.1, projection, rounding));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(band) { return element_kind<Band>("band"); }
