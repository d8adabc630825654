// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/cells/rule.h>
#include <vug/cells/seeds.h>

#include <algorithm>

namespace vug::cells {
namespace {

/// A cell is overgrown with a probability that increases with its overgrown neighbours (Eden
/// growth), which gives clumps a ragged edge. The cover closes and swells with time, so clumps form
/// cushions. Overgrown cells take the colour of the neighbour that was first.
struct Moss {
  double seeds = 40;
  double speed = 0.005;
  double thickness = 0.012;
  double ripe = 30;
  double moisture = 0.2;
  double light = 0.05;
  Vec3d from{0.02, 0.05, 0.006};
  Vec3d to{0.1, 0.16, 0.025};

  static void describe(Schema<Moss>& s) {
    s.doc(
         "Clumps that grow from seeds over the surrounding cells, where moisture and light allow. "
         "Provides moss (0 bare, 1 closed), Cd and height.")
        .cite("eden1961");
    describe_growth(s);
    s.param("speed", &Moss::speed,
            positive_length("growth of the edge of a clump per step, at most one spacing"))
        .param("thickness", &Moss::thickness,
               {.doc = "height of old moss", .dimension = Dimension::length, .min = 0})
        .param("ripe", &Moss::ripe, {.doc = "steps in which 63% of the thickness grows", .min = 1})
        .param(
            "from", &Moss::from,
            {.doc = "minimum of each channel of the colours of clumps, linear", .min = 0, .max = 1})
        .param("to", &Moss::to, {.doc = "maximum of each channel", .min = 0, .max = 1});
  }

  void step(Pass& pass) const {
    const Network& network = pass.network();
    const auto moss = pass.writes<float>("moss"), height = pass.writes<float>("height");
    const auto color = pass.writes<Vec3f>("Cd");
    const OptionalReader moist = pass.reads_optional("moisture", 1),
                         lit = pass.reads_optional("light", 1);
    const double chance = std::min(1.0, speed / network.spacing);
    const auto closes = static_cast<float>(1 - maths::exp(-1 / ripe));
    const auto thick = static_cast<float>(thickness);
    const auto begins = [&](uint32_t i) {
      return pass.step() == 0 && is_seed(network, i, seeds, pass.key().at("seeds"));
    };
    pass.run([&](const auto& neighbours, uint32_t i) {
      const float thrive = growth_response(moist[i], moisture) * growth_response(lit[i], light);
      float grown = moss[i];
      Vec3f shade = color[i];
      if (grown > 0) {
        grown += closes * thrive * (1 - grown);
      } else if (thrive > 0) {
        uint32_t first = i;
        float oldest = 0;
        int around = 0;
        neighbours.each(i, [&](uint32_t n) {
          around += moss[n] > 0;
          if (moss[n] > oldest) oldest = moss[n], first = n;
        });
        RandomStream random = pass.random(i);
        // At a straight edge half of the neighbours are overgrown.
        const double odds = chance * static_cast<double>(thrive) * 2 * around / network.full;
        if (begins(i)) {
          grown = closes;
          shade = drawn(pass.key().at("color").at(position_key(network.position[i])));
        } else if (around > 0 && random.uniform() < odds) {
          grown = closes * thrive;
          shade = color[first] * static_cast<float>(random.uniform(0.94, 1.06));
        }
      }
      height.set(i, height[i] + thick * (grown - moss[i]));
      moss.set(i, grown);
      color.set(i, shade);
    });
  }

 private:
  /// The colour of a clump: all channels lighter or darker together, with some variation between
  /// them.
  Vec3f drawn(RandomKey key) const {
    RandomStream random(key);
    const double both = random.uniform();
    Vec3f out;
    for (int c = 0; c < 3; ++c)
      out[c] =
          static_cast<float>(from[c] + (to[c] - from[c]) * (0.7 * both + 0.3 * random.uniform()));
    return out;
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(moss) { return rule_kind<Moss>("moss"); }
