// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// The last row of the paper's table 1. The defaults are those of [@young1984].
struct Regrouping {
  double near = 2.3;
  double far = 6.01;
  double attract = 1;
  double repel = -0.24;
  double bias = 0;

  static void describe(Schema<Regrouping>& s) {
    s.doc(
         "Each cell joins one of two groups (group: 1 or -1) by the votes of the surrounding "
         "cells: spots, stripes or islands. Initially cells without a group choose one at random.")
        .cite("gobron2006")
        .param(
            "near", &Regrouping::near,
            {.doc = "radius in spacings within which a vote counts `attract`", .min = 0, .max = 16})
        .param("far", &Regrouping::far,
               {.doc = "radius in spacings up to which farther votes count `repel`",
                .min = 0,
                .max = 16})
        .param("attract", &Regrouping::attract, {.doc = "weight of a near vote"})
        .param("repel", &Regrouping::repel, {.doc = "weight of a far vote"})
        .param("bias", &Regrouping::bias, {.doc = "bias added to the votes"});
  }
  std::string fault() const { return far < near ? "'far' must not be less than 'near'" : ""; }

  void step(Pass& pass) const {
    const Network& network = pass.network();
    const auto group = pass.writes<int32_t>("group");
    const auto state = pass.states();
    if (pass.step() == 0)
      return pass.run([&](const auto&, uint32_t i) {
        const int32_t drawn = pass.random(i).uniform() < 0.5 ? -1 : 1;
        group.set(i, group[i] != 0 ? group[i] : drawn);
      });
    const Links& around = pass.within(far * network.spacing);
    const auto limit = static_cast<float>(near * near * network.spacing * network.spacing);
    pass.run([&](const auto&, uint32_t i) {
      int32_t inner = 0, outer = 0;
      for (const uint32_t n : around.of(i)) {
        if (!distributes(state[n])) continue;
        const bool is_near = (network.position[n] - network.position[i]).length2() < limit;
        (is_near ? inner : outer) += group[n];
      }
      const double votes = bias + attract * inner + repel * outer;
      group.set(i, votes > 0 ? 1 : votes < 0 ? -1 : group[i]);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(regrouping) { return rule_kind<Regrouping>("regrouping"); }
