// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

struct Melting {
  double rate = 1;

  static void describe(Schema<Melting>& s) {
    s.doc(
         "Moves each cell (P) to the mean of its own position and its neighbours', and also "
         "averages its normal (N): small features melt first.")
        .cite("gobron2006")
        .param("rate", &Melting::rate,
               {.doc = "fraction of that displacement per step; 100% is the paper's",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1});
  }

  void step(Pass& pass) const {
    const auto p = pass.writes_positions();
    const auto n = pass.writes_normals();
    pass.run([=, fraction = static_cast<float>(rate)](const auto& neighbours, uint32_t i) {
      Vec3f place = p[i], facing = n[i];
      const uint32_t k = neighbours.each(i, [&](uint32_t j) { place += p[j], facing += n[j]; });
      const float one = 1 / static_cast<float>(k + 1);
      p.set(i, p[i] + (place * one - p[i]) * fraction);
      const Vec3f turned = n[i] + (facing * one - n[i]) * fraction;
      n.set(i, turned.length2() > 1e-12f ? turned.normalized() : n[i]);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(melting) { return rule_kind<Melting>("melting"); }
