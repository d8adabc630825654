// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/cells/rule.h>
#include <vug/cells/seeds.h>

#include <algorithm>

namespace vug::cells {
namespace {

/// Crustose lichens grow outwards at a constant rate and stop where they meet. Each colony knows
/// its centre, so that rosettes are round on any grid.
struct Lichen {
  double seeds = 25;
  double size = 0.08;
  double speed = 0.001;
  double rim = 0.006;
  double lobes = 0.12;
  double thickness = 0.002;
  double moisture = 0;
  double light = 0.05;
  std::vector<Vec3d> colors{
      {0.46, 0.48, 0.38}, {0.6, 0.58, 0.5}, {0.62, 0.4, 0.06}, {0.3, 0.34, 0.2}};
  Vec3d line{0.03, 0.03, 0.025};

  static void describe(Schema<Lichen>& s) {
    s.doc(
         "Rosettes of several colours that grow from seeds, with pale rims and dark lines where "
         "two meet. Provides lichen (1 in rosettes, 0.5 on lines), colony (numbers of their "
         "seeds), Cd and height.")
        .cite("desbenoit2004lichen");
    describe_growth(s);
    s.param("size", &Lichen::size, positive_length("radius of the largest rosettes"))
        .param("speed", &Lichen::speed, positive_length("growth of young rims per step"))
        .param("rim", &Lichen::rim,
               {.doc = "width of the pale rim", .dimension = Dimension::length, .min = 0})
        .param("lobes", &Lichen::lobes,
               {.doc = "depth of lobes as a fraction of the radius",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 0.5})
        .param("thickness", &Lichen::thickness,
               {.doc = "height of rosettes", .dimension = Dimension::length, .min = 0})
        .param("colors", &Lichen::colors,
               {.doc = "colours of rosettes, one of which is chosen for each, linear",
                .min = 0,
                .max = 1})
        .param("line", &Lichen::line,
               {.doc = "colour of the lines where two meet, linear", .min = 0, .max = 1});
  }
  std::string fault() const { return colors.empty() ? "lichens need at least one colour" : ""; }

  void step(Pass& pass) const {
    const Network& network = pass.network();
    const auto cover = pass.writes<float>("lichen"), height = pass.writes<float>("height");
    const auto colony = pass.writes<int32_t>("colony");
    const auto color = pass.writes<Vec3f>("Cd");
    const OptionalReader moist = pass.reads_optional("moisture", 1),
                         lit = pass.reads_optional("light", 1);
    const auto thick = static_cast<float>(thickness);
    const auto edge = static_cast<float>(std::max(rim, 1e-6));
    const RandomKey key = pass.key();
    const int age = pass.step();
    pass.run([&](const auto& neighbours, uint32_t i) {
      const float thrive = growth_response(moist[i], moisture) * growth_response(lit[i], light);
      int32_t own = colony[i];
      bool meets = false;
      float left = 0;  // Metres to the rim.
      if (own == 0 && age == 0 && thrive > 0 && is_seed(network, i, seeds, key.at("seeds")))
        own = static_cast<int32_t>(i) + 1;
      if (own == 0 && thrive > 0) {
        float most = 0;
        neighbours.each(i, [&](uint32_t n) {
          if (colony[n] == 0) return;
          const float deep = depth(network, colony[n], i, thrive, age, key);
          if (deep > most) most = deep, own = colony[n];
        });
        left = most;
      } else if (own != 0) {
        neighbours.each(i, [&](uint32_t n) { meets |= colony[n] != 0 && colony[n] != own; });
        left = depth(network, own, i, thrive, age, key);
      }
      const float now = own == 0 ? 0.0f : meets ? 0.5f : 1.0f;
      height.set(i, height[i] + thick * (now - cover[i]));
      cover.set(i, now);
      colony.set(i, own);
      if (own == 0) return color.set(i, color[i]);
      if (meets) return color.set(i, Vec3f(line));
      const float pale = 0.45f * std::clamp(1 - left / edge, 0.0f, 1.0f);
      color.set(i, shade(network, own, i, key) * (1 - pale) + Vec3f(0.8f) * pale);
    });
  }

 private:
  /// Distance by which the rim of a colony has passed a cell; 0 or negative: not reached.
  float depth(const Network& n, int32_t colony, uint32_t cell, float thrive, int age,
              RandomKey key) const {
    const auto seed = static_cast<uint32_t>(colony - 1);
    RandomStream random(key.at("colony").at(position_key(n.position[seed])));
    const double drawn = random.uniform();
    const double most = size * (0.2 + 0.8 * drawn * drawn);
    const double phase = random.uniform(0, 2 * kPi), count = 5 + random.below(6);
    const Vec3f offset = n.position[cell] - n.position[seed];
    const auto far = static_cast<double>(offset.length());
    const double turn = maths::atan2(static_cast<double>(offset.dot(ahead(n, seed))),
                                     static_cast<double>(offset.dot(n.right[seed])));
    // Lobes bulge between sharp notches, and each cell of a rim is reached slightly early or late.
    const double wave = maths::sin(count * turn / 2 + phase);
    const double bulge = 1 - lobes * (1 - 2 * wave * wave + wave * wave * wave * wave);
    const double ragged =
        RandomStream(key.at("rim").at(position_key(n.position[cell]))).uniform(-0.3, 0.3) *
        n.spacing;
    const double grown = most * (1 - maths::exp(-speed * (age + 1) / most));
    return static_cast<float>(grown * bulge * static_cast<double>(thrive) + ragged - far);
  }
  Vec3f shade(const Network& n, int32_t colony, uint32_t cell, RandomKey key) const {
    const uint64_t seed = position_key(n.position[static_cast<size_t>(colony - 1)]);
    RandomStream random(key.at("color").at(seed));
    const Vec3d& taken = colors[random.below(static_cast<uint32_t>(colors.size()))];
    const double tone = random.uniform(0.85, 1.15);
    const double grain =
        RandomStream(key.at("grain").at(position_key(n.position[cell]))).uniform(0.88, 1.12);
    return Vec3f(taken * (tone * grain));
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(lichen) { return rule_kind<Lichen>("lichen"); }
