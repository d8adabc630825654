// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

#include <algorithm>

namespace vug::cells {
namespace {

/// The diffusion along each link does not depend on the degrees of its ends, so that the outflow of
/// one cell equals the inflow of the other: without feed and kill, u + v is conserved.
struct GrayScott {
  double feed = 0.055;
  double kill = 0.062;
  double diffusion_u = 0.8;
  double diffusion_v = 0.4;

  static void describe(Schema<GrayScott>& s) {
    const auto share = [](std::string doc) { return ParamSpec{.doc = doc, .min = 0, .max = 1}; };
    s.doc(
         "Reaction and diffusion of two substances, u (initially 1) and v (0; sprinkle some): "
         "spots, stripes, coral.")
        .cite("pearson1993")
        .param("feed", &GrayScott::feed, share("rate at which u is added"))
        .param("kill", &GrayScott::kill,
               share("rate at which v is removed, in addition to the feed rate"))
        .param("diffusion_u", &GrayScott::diffusion_u,
               share("fraction of u that diffuses to neighbours"))
        .param("diffusion_v", &GrayScott::diffusion_v,
               share("fraction of v that diffuses to neighbours"));
  }

  void step(Pass& pass) const {
    const auto u = pass.writes<float>("u", 1);
    const auto v = pass.writes<float>("v", 0);
    const auto full = static_cast<float>(pass.network().full);
    const float du = static_cast<float>(diffusion_u) / full;
    const float dv = static_cast<float>(diffusion_v) / full;
    const auto f = static_cast<float>(feed), k = static_cast<float>(kill);
    pass.run_on_sums(u, v, [=](FloatPair own, FloatPair sum, float links) {
      // Limits the reaction to the available u; this has no effect while v is below 1, as it is
      // except in drops.
      const float reaction = own.a * std::min(1.0f, own.b * own.b);
      return FloatPair{own.a + du * (sum.a - links * own.a) - reaction + f * (1 - own.a),
                       own.b + dv * (sum.b - links * own.b) + reaction - (f + k) * own.b};
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(gray_scott) { return rule_kind<GrayScott>("gray_scott"); }
