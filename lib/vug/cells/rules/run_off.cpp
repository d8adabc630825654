// SPDX-License-Identifier: Apache-2.0
// In a steady flow, water equals the rain on all the rock above, per metre of width: the specific
// catchment area of hydrology.
#include <vug/base/maths.h>
#include <vug/cells/flow.h>
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

struct RunOff {
  double speed = 0.05;
  double dry = 2;
  double settle = 0.4;
  double strength = 0.01;
  int gather = 2;
  double wander = 0.3;
  double cling = 0.9;

  static void describe(Schema<RunOff>& s) {
    s.doc(
         "Water enters at `source` (everywhere, if there is no such attribute), runs down from "
         "cell to cell, gathers in streaks and leaves stains of what it carries. Provides water "
         "(metres of rock that drain here), load, stain (about 1 where rain has fallen everywhere "
         "for 1 / strength steps) and lost (water that dried or fell off).")
        .cite("freeman1991")
        .param("speed", &RunOff::speed, positive_length("distance that water runs per step"))
        .param("dry", &RunOff::dry, positive_length("distance over which water dries to 37%"))
        .param("settle", &RunOff::settle,
               positive_length("distance over which its load settles to 37%"))
        .param("strength", &RunOff::strength, {.doc = "stain left per step", .min = 0})
        .param("gather", &RunOff::gather,
               {.doc = "exponent of steepness: 1 spreads over all lower neighbours, 8 takes the "
                       "steepest path",
                .min = 1,
                .max = 8})
        .param("wander", &RunOff::wander,
               {.doc = "roughness of walls in spacings, which diverts streaks from straight lines",
                .min = 0,
                .max = 4})
        .param("cling", &RunOff::cling,
               {.doc = "cohesion of water, so that streaks join and stay narrow",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1});
  }

  void step(Pass& pass) const {
    pass.writes<float>("water"), pass.writes<float>("load");
    pass.writes<float>("stain"), pass.writes<float>("lost");
    const double spacing = pass.network().spacing;
    const Flow flow(pass, pass.key().at("wander"), {gather, wander, cling});
    const OptionalReader source = pass.reads_optional("source", 1);
    const auto rain = static_cast<float>(spacing);
    const auto kept = static_cast<float>(maths::exp(-spacing / dry));
    const auto carried = static_cast<float>(maths::exp(-spacing / settle));
    const auto tint = static_cast<float>(strength / speed);
    for (int turn = moves_in_step(speed, spacing, pass.step()); turn > 0; --turn) {
      const auto water = pass.writes<float>("water");
      const auto load = pass.writes<float>("load");
      const auto stain = pass.writes<float>("stain");
      const auto lost = pass.writes<float>("lost");
      pass.run([&](const auto&, uint32_t i) {
        const float enters = rain * source[i];
        water.set(i, enters + flow.inflow([&](uint32_t n) { return kept * water[n]; }, i));
        load.set(i, enters + flow.inflow([&](uint32_t n) { return carried * load[n]; }, i));
        stain.set(i, stain[i] + tint * (1 - carried) * load[i]);
        lost.set(i, lost[i] + (flow.is_sink(i) ? water[i] : (1 - kept) * water[i]));
      });
    }
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(run_off) { return rule_kind<RunOff>("run_off"); }
