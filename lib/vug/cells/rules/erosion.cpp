// SPDX-License-Identifier: Apache-2.0
// Water erodes rock in proportion to its power (discharge times slope) up to its transport
// capacity, and deposits what exceeds the capacity. All cells count as equally large.
#include <vug/cells/flow.h>
#include <vug/cells/rule.h>

#include <algorithm>

namespace vug::cells {
namespace {

struct Erosion {
  double wear = 2e-4;
  double depth = 0.05;
  double carry = 0.01;
  double settle = 0.3;
  double full = 1;
  double speed = 0.05;
  int gather = 3;
  double wander = 0.3;

  static void describe(Schema<Erosion>& s) {
    s.doc(
         "Running water carves rock, more on steeper slopes and in weaker rock (hardness 0 to 1 "
         "reduces erosion; 0 if there is no such attribute), and deposits what it cannot carry. "
         "Provides height (negative where carved), carved (metres), sediment (in transport) and "
         "washed (removed). The water is that of `run_off`; without it all cells are equally wet.")
        .cite("whipple1999")
        .param("wear", &Erosion::wear,
               {.doc = "depth carved per step where water is full and runs vertically",
                .dimension = Dimension::length,
                .min = 0})
        .param("depth", &Erosion::depth, positive_length("maximum depth carved or deposited"))
        .param("carry", &Erosion::carry,
               positive_length("maximum layer of sediment that such water carries"))
        .param("settle", &Erosion::settle,
               {.doc = "fraction of the excess sediment deposited per move",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("full", &Erosion::full,
               {.doc = "value of water with full power", .min = 0, .above_min = true})
        .param("speed", &Erosion::speed, positive_length("distance that sediment moves per step"))
        .param("gather", &Erosion::gather,
               {.doc = "exponent of steepness, as in run_off", .min = 1, .max = 8})
        .param("wander", &Erosion::wander,
               {.doc = "roughness of walls in spacings, as in run_off", .min = 0, .max = 4});
  }

  void step(Pass& pass) const {
    pass.writes<float>("carved"), pass.writes<float>("height");
    pass.writes<float>("sediment"), pass.writes<float>("washed");
    const double spacing = pass.network().spacing;
    const int turns = moves_in_step(speed, spacing, pass.step());
    const Flow flow(pass, pass.key().at("wander"), {gather, wander, 0});
    const auto fullness = static_cast<float>(full);
    const OptionalReader water = pass.reads_optional("water", fullness),
                         hardness = pass.reads_optional("hardness", 0);
    const auto most = static_cast<float>(depth), holds = static_cast<float>(carry);
    const auto takes = static_cast<float>(wear * spacing / speed);
    const auto leaves = static_cast<float>(settle);
    const auto pit = static_cast<float>(spacing / 4);
    const Vec3f* normal = pass.network().normal.data();
    for (int turn = 0; turn < turns; ++turn) {
      const auto carved = pass.writes<float>("carved"), height = pass.writes<float>("height");
      const auto load = pass.writes<float>("sediment"), washed = pass.writes<float>("washed");
      pass.run([&](const auto&, uint32_t i) {
        const float arrives = flow.inflow([&](uint32_t n) { return load[n]; }, i);
        const float steep = flow.steepness(i);
        const float power = std::clamp(water[i] / fullness, 0.0f, 1.0f) * steep;
        const float carries = holds * power;
        float taken = 0;
        if (arrives > carries) {
          // Pits fill up to their rim; nothing rests on overhangs.
          float room = std::max(0.0f, most + carved[i]);
          if (flow.is_sink(i))
            room = std::min(room, flow.sink_depth(i) / static_cast<float>(turns));
          taken = normal[i].y > 0 ? -std::min(leaves * (arrives - carries), room) : 0;
        } else if (carries > 0) {
          const float soft = std::clamp(1 - hardness[i], 0.0f, 1.0f);
          const float free = 1 - arrives / carries;
          taken = std::min(
              {takes * power * soft * free, pit * steep, std::max(0.0f, most - carved[i])});
        }
        carved.set(i, carved[i] + taken);
        height.set(i, height[i] - taken);
        load.set(i, arrives + taken);
        washed.set(i, washed[i] + (flow.is_sink(i) ? load[i] : 0));
      });
    }
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(erosion) { return rule_kind<Erosion>("erosion"); }
