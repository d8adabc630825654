// SPDX-License-Identifier: Apache-2.0
// Notches in the walls at the levels of still water: a flat roof at the level, and a facet below it
// that slopes out, where sediment protects the rock.
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/notch_profile.h>

#include <vector>

namespace vug::field {
namespace {

struct WaterNotch {
  std::vector<double> levels{0};
  double height = 0.6;
  double roof = 0.1;
  double wander = 0.3;
  double reach = 2;
  int seed = 1;

  static void describe(Schema<WaterNotch>& s) {
    s.doc(
         "Horizontal notches where still water dissolved the walls: -1 just below the level of the "
         "water, 0 above it and below the notch. Use them on walls; an amount of about the height "
         "makes a facet of 45 degrees.")
        .cite("lange1962")
        .param("levels", &WaterNotch::levels,
               {.doc = "heights of the surfaces of the water, which are the roofs of the notches",
                .dimension = Dimension::length})
        .param("height", &WaterNotch::height, positive_length("height of the facet below a level"))
        .param("roof", &WaterNotch::roof,
               {.doc = "height of the roof's edge, as a fraction of the height",
                .dimension = Dimension::ratio,
                .min = 0.02,
                .max = 1})
        .param("wander", &WaterNotch::wander,
               {.doc = "variation of the depth along the wall; 0 is even",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("reach", &WaterNotch::reach, positive_length("wavelength of the variation"))
        .param("seed", &WaterNotch::seed,
               {.doc = "random seed; each seed gives another variation"});
  }
  std::string fault() const { return levels.empty() ? "a notch needs at least one level" : ""; }
};

class Notch {
 public:
  explicit Notch(const WaterNotch& w)
      : w_(w),
        profile_{w.height, w.roof},
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(w.seed)).at("water_notch")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    T depth(0.0);
    for (const double level : w_.levels) depth = max(depth, profile_.depth(T(level) - p.y));
    if (w_.wander == 0) return -depth;
    const Point<T> q{p.x * T(1 / w_.reach), T(0.5), p.z * T(1 / w_.reach)};
    const T wave = clamp(gradient_noise(q, seed_), T(-1.0), T(1.0));
    return -depth * (T(1 - 0.5 * w_.wander) + wave * T(0.5 * w_.wander));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 0}; }
  double lipschitz() const {
    return profile_.slope() + 0.5 * w_.wander * kGradientNoiseSlope / w_.reach;
  }

 private:
  WaterNotch w_;
  NotchProfile profile_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(water_notch) {
  return noise_kind<WaterNotch>("water_notch", [](const WaterNotch& w) { return Notch(w); });
}
