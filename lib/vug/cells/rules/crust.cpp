// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

#include <algorithm>

namespace vug::cells {
namespace {

/// Calcite precipitates from a thin film of water at a rate that depends on the film, not on the
/// surface below. Knobs extend further into the air and grow faster.
struct Crust {
  double growth = 1e-4;
  double limit = 0.03;
  double lumps = 0.5;
  double smooth = 0.1;
  std::string from = "water";
  double full = 0.3;

  static void describe(Schema<Crust>& s) {
    const auto share = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = 1};
    };
    s.doc(
         "Mineral crust that thickens under running water (everywhere, if there is no such "
         "attribute). Provides crust (thickness) and height, which grows by it.")
        .cite("dreybrodt1980")
        .param("growth", &Crust::growth,
               {.doc = "thickness added per step", .dimension = Dimension::length, .min = 0})
        .param("limit", &Crust::limit, positive_length("maximum thickness"))
        .param("lumps", &Crust::lumps, share("irregularity of the growth: 0 smooth, 100% in knobs"))
        .param("smooth", &Crust::smooth,
               share("fraction of the differences between neighbours that a step smooths"))
        .param("from", &Crust::from, {.doc = "the attribute under which it grows"})
        .param("full", &Crust::full,
               {.doc = "value of that attribute with the fastest growth",
                .min = 0,
                .above_min = true});
  }

  void step(Pass& pass) const {
    const Network& network = pass.network();
    const auto crust = pass.writes<float>("crust"), height = pass.writes<float>("height");
    const OptionalReader water = pass.reads_optional(from, static_cast<float>(full));
    const auto wets = static_cast<float>(1 / full), adds = static_cast<float>(growth);
    const auto given = static_cast<float>(smooth / network.full);
    const auto most = static_cast<float>(limit), knobs = static_cast<float>(lumps);
    const auto stands = static_cast<float>(4 / network.spacing);
    const RandomKey key = pass.key().at("lumps");
    pass.run([&](const auto& neighbours, uint32_t i) {
      const float own = crust[i];
      float around = 0;
      const auto links =
          static_cast<float>(neighbours.each(i, [&](uint32_t n) { around += crust[n]; }));
      float pace = 1;
      if (knobs > 0) {
        const auto chance = static_cast<float>(
            RandomStream(key.at(position_key(network.position[i]))).uniform(-1, 1));
        const float out = links > 0 ? own - around / links : 0;
        pace = std::clamp(1 + knobs * (chance + stands * out), 0.0f, 2.0f);
      }
      const float wet = std::clamp(wets * water[i], 0.0f, 1.0f);
      const float more = adds * wet * pace * std::max(0.0f, 1 - own / most);
      const float now = own + more + given * (around - links * own);
      height.set(i, height[i] + (now - own));
      crust.set(i, now);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(crust) { return rule_kind<Crust>("crust"); }
