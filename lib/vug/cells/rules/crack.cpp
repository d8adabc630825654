// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// A cracked cell sleeps, so its neighbours do not see the new colour and do not crack because of
/// it.
struct Crack {
  Vec3d color{0.03, 0.025, 0.02};

  static void describe(Schema<Crack>& s) {
    s.doc(
         "Cells with a neighbour of another colour (Cd) take the colour of cracks, get crack = 1 "
         "and sleep.")
        .cite("gobron2006")
        .param("color", &Crack::color, {.doc = "colour of cracks, linear", .min = 0, .max = 1});
  }

  void step(Pass& pass) const {
    const auto own = pass.writes<Vec3f>("Cd");
    const auto crack = pass.writes<float>("crack");
    const auto state = pass.writes_states();
    pass.run([=, dark = Vec3f(color)](const auto& neighbours, uint32_t i) {
      bool differs = false;
      neighbours.each(i, [&](uint32_t n) {
        differs |= own[n] != own[i] && own[n] != Vec3f(0) && own[i] != Vec3f(0);
      });
      own.set(i, differs ? dark : own[i]);
      crack.set(i, differs ? 1 : crack[i]);
      state.set(i, differs ? CellState::sleeping : state[i]);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(crack) { return rule_kind<Crack>("crack"); }
