// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Shop : Opening {
  double riser = 0.5;
  double sign = 0.5;
  int bays = 3;

  static void describe(Schema<Shop>& s) {
    s.doc("A shop front: panes over a riser, between posts, under a sign board.")
        .cite("ripperda2009")
        .param("riser", &Shop::riser,
               {.doc = "height of the panel below the panes",
                .dimension = Dimension::length,
                .min = 0})
        .param("sign", &Shop::sign,
               {.doc = "height of the sign board above the panes",
                .dimension = Dimension::length,
                .min = 0})
        .param("bays", &Shop::bays, {.doc = "number of panes side by side", .min = 1, .max = 100});
    describe_opening(s);
  }
  std::string fault() const { return opening_fault(); }

  Solids solids(double width, double height) const {
    const double below = std::min(riser, height / 3), above = std::min(sign, height / 4);
    const double front = 0.05, back = reveal + 0.1, post = std::min(0.1, width / (4.0 * bays));
    Solids out = around(width, height, back);
    const double tall = height - below - above, wide = (width - post * (bays + 1)) / bays;
    std::vector<field::Field> panes;
    for (int i = 0; i < bays; ++i)
      panes.push_back(
          arched_block({post + i * (wide + post), below, wide, tall}, head, rise, -1e2, 1e2));
    out.add.push_back(
        field::subtract(block({0, 0, width, height}, -back, -0.5 * reveal), std::move(panes)));
    const double glass = -reveal - 0.015;
    out.fill.push_back(block({0, below, width, tall}, glass - kPane, glass));
    if (above > 0)
      out.add.push_back(moulding({{-back, height - above},
                                  {front, height - 0.9 * above},
                                  {front, height - 0.25 * above},
                                  {2.5 * front, height - 0.1 * above},
                                  {2.5 * front, height},
                                  {-back, height}},
                                 0, width));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(shop) { return element_kind<Shop>("shop"); }
