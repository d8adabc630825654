// SPDX-License-Identifier: Apache-2.0
// Crenulation: the small level ripples of steep speleothems, about 1 cm high whatever their size.
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>

namespace vug::field {
namespace {

struct Crenulation {
  double wavelength = 0.01;
  double wander = 0.6;
  double reach = 0.15;
  int seed = 1;

  static void describe(Schema<Crenulation>& s) {
    s.doc(
         "Level ripples of steep speleothems: 1 on the crests, -1 between them, and steeper "
         "below a crest than above it. Use them on walls only, with an amount of 0.5 mm to 2 mm.")
        .cite("hill1997")
        .param("wavelength", &Crenulation::wavelength,
               positive_length("height from crest to crest: 1 cm on all speleothems and icicles"))
        .param("wander", &Crenulation::wander,
               {.doc = "how far crests rise and fall, in wavelengths; 0 is level",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 3})
        .param("reach", &Crenulation::reach,
               positive_length("wavelength of this variation along the crests"))
        .param("seed", &Crenulation::seed,
               {.doc = "random seed; each seed gives another variation"});
  }
};

class Ripples {
 public:
  explicit Ripples(const Crenulation& c)
      : c_(c),
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(c.seed)).at("crenulation")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    T turns = p.y * T(1 / c_.wavelength);
    if (c_.wander > 0) {
      const T k(1 / c_.reach);
      turns = turns + gradient_noise(Point<T>{p.x * k, p.y * k, p.z * k}, seed_) * T(c_.wander);
    }
    // Rises from the low to the crest over the first part of a wave, and falls over the rest.
    const T part = turns - floor(turns);
    const T below = part * T(1 / kRise), above = (T(1.0) - part) * T(1 / (1 - kRise));
    const T t = min(below, above);
    return t * t * (T(6.0) - T(4.0) * t) - T(1.0);
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 1}; }
  double lipschitz() const {
    return 3 / kRise * (1 / c_.wavelength + c_.wander * kGradientNoiseSlope / c_.reach);
  }

 private:
  static constexpr double kRise = 0.35;
  Crenulation c_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(crenulation) {
  return noise_kind<Crenulation>("crenulation", [](const Crenulation& c) { return Ripples(c); });
}
