// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/diffusion.h>
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// Flowing moisture carries brine with the concentration of its origin; the excess over saturation
/// crystallises. So salt forms a line at some distance from the wet area, as on walls.
struct Efflorescence {
  double solubility = 2;
  double dissolve = 0.1;
  double creep = 0.03;
  std::string from = "water";
  double full = 0.3;

  static void describe(Schema<Efflorescence>& s) {
    s.doc(
         "Salt carried by moisture (brine) crystallises where it dries (salt) and dissolves where "
         "it becomes wet again. Water supplies brine of strength 1; without water, all moisture "
         "has that strength initially. Place it after `moisture`, with the same creep.")
        .cite("hall2002")
        .param("solubility", &Efflorescence::solubility,
               {.doc = "maximum strength of brine: the greater, the further from the wet area salt "
                       "begins",
                .min = 0,
                .above_min = true})
        .param("dissolve", &Efflorescence::dissolve,
               {.doc = "fraction of the soluble salt that dissolves per step",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1});
    describe_diffusion(s);
  }

  void step(Pass& pass) const {
    if (!pass.has("brine")) {
      const auto moist = pass.reads<float>("moisture");
      const auto brine = pass.writes<float>("brine");
      pass.run([=](const auto&, uint32_t i) { brine.set(i, moist[i]); });
    }
    const Network& network = pass.network();
    const DiffusionSteps seep(creep, network.spacing);
    const auto given = static_cast<float>(seep.share / network.full);
    const auto most = static_cast<float>(solubility);
    const auto thaw = static_cast<float>(dissolve / seep.rounds);
    const OptionalReader water = pass.reads_optional(from, 0);
    const auto wets = static_cast<float>(1 / full);
    for (int round = 0; round < seep.rounds; ++round) {
      const auto moist = pass.reads<float>("moisture");
      const auto brine = pass.writes<float>("brine");
      const auto salt = pass.writes<float>("salt");
      const auto strength = [=](uint32_t c) {
        return moist[c] > 1e-6f ? std::min(brine[c] / moist[c], most) : 0.0f;
      };
      pass.run([=](const auto& neighbours, uint32_t i) {
        const float here = moist[i], own = strength(i);
        float came = 0;
        neighbours.each(i, [&](uint32_t n) {
          const float flow = moist[n] - here;
          came += flow > 0 ? flow * strength(n) : flow * own;
        });
        const float fed = std::min(1.0f, wets * water[i]);  // The brine of running water.
        const float has = std::max(brine[i] + given * came, fed), holds = most * here;
        const float freed = has < holds ? std::min(salt[i], thaw * (holds - has)) : holds - has;
        brine.set(i, has + freed);
        salt.set(i, salt[i] - freed);
      });
    }
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(efflorescence) { return rule_kind<Efflorescence>("efflorescence"); }
