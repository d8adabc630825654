// SPDX-License-Identifier: Apache-2.0
// A plugin with one rule of cells, written like those in lib/vug/cells/rules:
//   cells skin on wall { spacing 2cm  run sprinkle("heat", share: 1%), cooling(rate: 5%) }
#include <vug/cells/rule.h>
#include <vug/loading/plugin.h>

namespace vug::cells {
namespace {

/// Heat diffusion: a cell takes the mean of its own heat and that of its neighbours, and loses a
/// fraction of it.
struct Cooling {
  double rate = 0.05;

  static void describe(Schema<Cooling>& s) {
    s.doc("Heat (heat) spreads to a cell's neighbours and is lost to the air.")
        .param("rate", &Cooling::rate,
               {.doc = "fraction that is lost in each step",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1});
  }

  void step(Pass& pass) const {
    const auto heat = pass.writes<float>("heat");
    const auto kept = static_cast<float>(1 - rate);
    pass.run([=](const auto& near, uint32_t i) {
      float sum = heat[i];
      const auto links = static_cast<float>(near.each(i, [&](uint32_t n) { sum += heat[n]; }));
      heat.set(i, kept * sum / (links + 1));
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(cooling) { return rule_kind<Cooling>("cooling"); }

VUG_PLUGIN(kinds) { kinds.add(vug::cells::cooling_rule()); }
