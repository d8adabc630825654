#include <vug/cells/rule.h>

#include <algorithm>

namespace vug::cells {
namespace {

/// The diffusion of each link is the same whatever the degrees of its ends, so what leaves one cell
/// arrives at the other: without feeding and killing, u + v is conserved.
struct GrayScott {
  double feed = 0.055;
  double kill = 0.062;
  double diffusion_u = 0.8;
  double diffusion_v = 0.4;

  static void describe(Schema<GrayScott>& s) {
    const auto share = [](std::string doc) { return ParamSpec{.doc = doc, .min = 0, .max = 1}; };
    s.doc(
         "Reaction and diffusion of two substances, u (1 at first) and v (0; sprinkle some): "
         "spots, "
         "stripes, coral.")
        .cite("pearson1993")
        .param("feed", &GrayScott::feed, share("rate at which u is added"))
        .param("kill", &GrayScott::kill, share("rate at which v is taken away, beyond feeding"))
        .param("diffusion_u", &GrayScott::diffusion_u, share("share of u that goes to neighbours"))
        .param("diffusion_v", &GrayScott::diffusion_v, share("share of v that goes to neighbours"));
  }

  void step(Pass& pass) const {
    const auto u = pass.writes<float>("u", 1);
    const auto v = pass.writes<float>("v", 0);
    const auto full = static_cast<float>(pass.network().full);
    const float du = static_cast<float>(diffusion_u) / full;
    const float dv = static_cast<float>(diffusion_v) / full;
    const auto f = static_cast<float>(feed), k = static_cast<float>(kill);
    const auto kernel = [=](const auto& both) {
      return [=](const auto& near, uint32_t i) {
        const Pair own = both(i);
        const float own_u = own[0], own_v = own[1];
        Pair sum = {0, 0};
        const auto links = static_cast<float>(near.each(i, [&](uint32_t n) { sum += both(n); }));
        // No more of u than there is: the same while v is below 1, as it is but for drops.
        const float reaction = own_u * std::min(1.0f, own_v * own_v);
        u.set(i, own_u + du * (sum[0] - links * own_u) - reaction + f * (1 - own_u));
        v.set(i, own_v + dv * (sum[1] - links * own_v) + reaction - (f + k) * own_v);
      };
    };
    if (!pass.all_awake()) return pass.run(kernel([=](uint32_t n) { return Pair{u[n], v[n]}; }));
    const Pair* pairs = pass.pairs(u, v);
    pass.run(kernel([=](uint32_t n) { return pairs[n]; }));
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(gray_scott) { return rule_kind<GrayScott>("gray_scott"); }
