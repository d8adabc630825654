// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/field/boolean.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Door : Opening {
  int leaves = 1;
  int panels = 3;

  static void describe(Schema<Door>& s) {
    s.doc("A door: a hole with one or more leaves, each with sunk panels.")
        .cite("ripperda2009")
        .param("leaves", &Door::leaves,
               {.doc = "number of leaves side by side", .min = 1, .max = 4})
        .param("panels", &Door::panels,
               {.doc = "number of panels one above the other in a leaf", .min = 0, .max = 20});
    describe_opening(s);
  }
  std::string fault() const { return opening_fault(); }

  Solids solids(double width, double height) const {
    Solids out = around(width, height, reveal + 0.12);
    const double back = reveal + 0.08, leaf = width / leaves;
    std::vector<field::Field> sunk;
    for (int i = 0; i < leaves; ++i) {
      const double stile = std::min(0.12, leaf / 5);
      sunk.push_back(block({i * leaf - 0.004, -1, 0.008, height + 2}, -reveal - 0.02, 1));
      const double rise_left = rise_of(head, rise, width, height);
      const double tall = (height - rise_left - stile * (panels + 1)) / std::max(1, panels);
      for (int j = 0; j < panels && tall > 0.05; ++j)
        sunk.push_back(block({i * leaf + stile, stile + j * (tall + stile), leaf - 2 * stile, tall},
                             -reveal - 0.025, 1));
    }
    out.fill.push_back(field::subtract(sheet(width, height, back, reveal), std::move(sunk)));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(door) { return element_kind<Door>("door"); }
