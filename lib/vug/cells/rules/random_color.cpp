#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

struct RandomColor {
  double share = 1;

  static void describe(Schema<RandomColor>& s) {
    s.doc(
         "Gives cells a random colour each (Cd) and makes them seeds, for rules that spread from "
         "there; for a single step.")
        .cite("gobron2006")
        .param("share", &RandomColor::share,
               {.doc = "of the cells, chosen by chance",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1});
  }

  void step(Pass& pass) const {
    const auto color = pass.writes<Vec3f>("Cd");
    const auto seed = pass.writes<int32_t>("seed");
    pass.run([=, &pass, chance = share](const auto&, uint32_t i) {
      RandomStream random = pass.random(i);
      if (random.uniform() >= chance) return color.set(i, color[i]), seed.set(i, seed[i]);
      Vec3f drawn;
      for (int c = 0; c < 3; ++c) drawn[c] = static_cast<float>(1 - random.uniform());  // not 0
      color.set(i, drawn);
      seed.set(i, static_cast<int32_t>(i) + 1);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(random_color) { return rule_kind<RandomColor>("random_color"); }
