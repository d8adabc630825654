// Water in a steady flow is the rain of all the rock above, per metre across: what hydrology calls
// the specific catchment area.
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
         "Water enters where `source` says (everywhere where nobody does), runs down from cell to "
         "cell, gathers in streaks and leaves a stain of what it carries. Brings water (metres of "
         "rock whose rain runs here), load, stain (about 1 where rain has fallen everywhere for "
         "1 / strength steps) and lost (water that dried or fell off).")
        .cite("freeman1991")
        .param("speed", &RunOff::speed, positive_length("way of the water in a step"))
        .param("dry", &RunOff::dry, positive_length("way on which all but 37% of the water dries"))
        .param("settle", &RunOff::settle,
               positive_length("way on which all but 37% of what it carries settles"))
        .param("strength", &RunOff::strength, {.doc = "stain that a step leaves", .min = 0})
        .param(
            "gather", &RunOff::gather,
            {.doc =
                 "power of steepness: 1 spreads over all that is lower, 8 takes the steepest way",
             .min = 1,
             .max = 8})
        .param("wander", &RunOff::wander,
               {.doc = "roughness of walls in spacings, by which streaks leave the straight way",
                .min = 0,
                .max = 4})
        .param("cling", &RunOff::cling,
               {.doc = "how much water follows water, so that streaks join and stay narrow",
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
