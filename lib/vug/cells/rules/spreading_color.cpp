// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// Cells without colour are 0 in all three channels.
struct SpreadingColor {
  static void describe(Schema<SpreadingColor>& s) {
    s.doc(
         "Colour (Cd) becomes the mean of a cell's own colour and its coloured neighbours': it "
         "spreads.")
        .cite("gobron2006");
  }

  void step(Pass& pass) const {
    const auto color = pass.writes<Vec3f>("Cd");
    pass.run([=](const auto& neighbours, uint32_t i) {
      Vec3f sum = color[i];
      int colored = 0;
      neighbours.each(i, [&](uint32_t n) {
        sum += color[n];
        colored += color[n] != Vec3f(0);
      });
      color.set(i, sum / static_cast<float>(colored + 1));
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(spreading_color) { return rule_kind<SpreadingColor>("spreading_color"); }
