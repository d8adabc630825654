// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

#include <algorithm>

namespace vug::cells {
namespace {

struct Watercolor {
  double loss = 0.01;

  static void describe(Schema<Watercolor>& s) {
    s.doc(
         "Water (wetness) spreads and dries; while a cell is wet its pigment (Cd) mixes with its "
         "neighbours', in proportion to the wetness.")
        .cite("gobron2006")
        .param("loss", &Watercolor::loss, {.doc = "loss of wetness per step", .min = 0});
  }

  void step(Pass& pass) const {
    const auto wet = pass.writes<float>("wetness");
    const auto pigment = pass.writes<Vec3f>("Cd");
    pass.run([=, dried = static_cast<float>(loss)](const auto& neighbours, uint32_t i) {
      float water = wet[i];
      Vec3f around(0);
      const uint32_t k =
          neighbours.each(i, [&](uint32_t n) { water += wet[n], around += pigment[n]; });
      wet.set(i, std::max(0.0f, water / static_cast<float>(k + 1) - dried));
      const float share = k > 0 ? std::min(1.0f, wet[i]) : 0;
      const Vec3f mean = around / static_cast<float>(std::max(k, 1u));
      pigment.set(i, pigment[i] + (mean - pigment[i]) * share);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(watercolor) { return rule_kind<Watercolor>("watercolor"); }
