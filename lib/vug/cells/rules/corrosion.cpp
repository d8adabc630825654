// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// Potential 0 is untouched. A cell whose potential is used up is removed, so its neighbours no
/// longer see it.
struct Corrosion {
  double share = 0.1;
  double potential = 1;
  double loss = 0.05;

  static void describe(Schema<Corrosion>& s) {
    s.doc(
         "Corrodes cells: potential falls step by step, and at the end the cell becomes "
         "transparent. An untouched cell is attacked when more than half of its neighbours are.")
        .cite("gobron2006")
        .param("share", &Corrosion::share,
               {.doc = "fraction of the patches grown around seeds (of the cells, if there are no "
                       "patches) that are attacked initially",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("potential", &Corrosion::potential,
               {.doc = "potential of a cell when it is attacked", .min = 0, .above_min = true})
        .param("loss", &Corrosion::loss, {.doc = "loss of potential per step", .min = 0});
  }

  void step(Pass& pass) const {
    const auto seed = pass.reads<int32_t>("seed");
    const auto p = pass.writes<float>("potential");
    const auto state = pass.writes_states();
    const auto attacked = [&pass, seed, this](uint32_t i) {
      if (pass.step() > 0) return false;
      const uint32_t patch = seed[i] > 0 ? static_cast<uint32_t>(seed[i] - 1) : i;
      return pass.random(patch).uniform() < share;
    };
    pass.run([=, most = static_cast<float>(potential), less = static_cast<float>(loss)](
                 const auto& neighbours, uint32_t i) {
      if (p[i] > 0) {
        p.set(i, p[i] > less ? p[i] - less : 0);
        return state.set(i, p[i] > less ? state[i] : CellState::transparent);
      }
      uint32_t carriers = 0;
      const uint32_t k = neighbours.each(i, [&](uint32_t n) { carriers += p[n] > 0; });
      p.set(i, 2 * carriers > k || attacked(i) ? most : 0);
      state.set(i, state[i]);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(corrosion) { return rule_kind<Corrosion>("corrosion"); }
