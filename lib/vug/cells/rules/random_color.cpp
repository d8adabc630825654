// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>
#include <vug/cells/selection.h>

namespace vug::cells {
namespace {

struct RandomColor : CellSelection {
  static constexpr bool kSingleStep = true;
  Vec3d from{0};
  Vec3d to{1};
  bool gradient = false;

  static void describe(Schema<RandomColor>& s) {
    s.doc(
         "Gives each cell a random colour (Cd) and makes it a seed, for rules that spread from "
         "there; for a single step.")
        .cite("gobron2006")
        .param("from", &RandomColor::from,
               {.doc = "minimum of each channel, exclusive, linear", .min = 0, .max = 1})
        .param("to", &RandomColor::to, {.doc = "maximum of each channel", .min = 0, .max = 1})
        .param("gradient", &RandomColor::gradient,
               {.doc = "one random number for all channels: colours on the line between both"});
    describe_selection(s);
  }

  void step(Pass& pass) const {
    const auto color = pass.writes<Vec3f>("Cd");
    const auto seed = pass.writes<int32_t>("seed");
    pass.run([=, &pass, p = *this](const auto&, uint32_t i) {
      RandomStream random = pass.random(i);
      if (random.uniform() >= p.at(pass.network(), i))
        return color.set(i, color[i]), seed.set(i, seed[i]);
      double fraction = 1 - random.uniform();
      Vec3f drawn;
      for (int c = 0; c < 3; ++c) {
        if (c > 0 && !p.gradient) fraction = 1 - random.uniform();
        drawn[c] = static_cast<float>(p.from[c] + (p.to[c] - p.from[c]) * fraction);
      }
      color.set(i, drawn);
      seed.set(i, static_cast<int32_t>(i) + 1);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(random_color) { return rule_kind<RandomColor>("random_color"); }
