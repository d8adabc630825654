// SPDX-License-Identifier: Apache-2.0
// Anastomoses: braided half-tubes that slow water dissolves along a bedding plane. The rock that is
// left between deep ones are pendants.
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/frame.h>
#include <vug/field/speleogens/plan_columns.h>

namespace vug::field {
namespace {

struct Anastomoses {
  double spacing = 0.7;
  double width = 0.2;
  Vec3d normal{0, 1, 0};
  double wander = 0.2;
  int seed = 1;

  static void describe(Schema<Anastomoses>& s) {
    s.doc(
         "Winding half-tubes that part and meet again in a bedding plane: -1 in the middle of a "
         "tube, 0 on the rock between them. Use them on ceilings: an amount of half the width "
         "makes half-tubes, a few widths make pendants of the rock between.")
        .cite("ewers1966")
        .param("spacing", &Anastomoses::spacing,
               positive_length("mean distance between the meshes of the braid"))
        .param("width", &Anastomoses::width,
               positive_length("width of a tube, 5 cm to 50 cm in caves"))
        .param("normal", &Anastomoses::normal,
               {.doc = "perpendicular to the beds, of any length but 0"})
        .param("wander", &Anastomoses::wander,
               {.doc = "sideways deviation of the tubes", .dimension = Dimension::length, .min = 0})
        .param("seed", &Anastomoses::seed, {.doc = "random seed; each seed gives different tubes"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal must not be zero";
    if (!(width < spacing)) return "the width of anastomoses must be below their spacing";
    return wander <= spacing ? "" : "'wander' must not exceed the spacing of the anastomoses";
  }
};

class Braid {
 public:
  explicit Braid(const Anastomoses& a)
      : across_(a.normal), spacing_(a.spacing), width_(a.width), wander_(a.wander) {
    RandomStream random(RandomKey(static_cast<uint64_t>(a.seed)).at("anastomoses"));
    for (uint32_t& seed : seeds_) seed = random.bits();
  }

  /// The tubes follow the borders of cells in the plane, where the centres of two cells are equally
  /// far. The difference of their distances is about twice the distance to the border.
  template <class T>
  T at(const Point<T>& p) const {
    const T u = dot(p, constant<T>(across_.side)) * T(1 / spacing_),
            v = dot(p, constant<T>(across_.up)) * T(1 / spacing_);
    const Point<T> low{u * T(kBends), v * T(kBends), T(0.5)};
    const T amount(wander_ / spacing_);
    const T apart = plan_column(T(u + amount * gradient_noise(low, seeds_[1])),
                                T(v + amount * gradient_noise(low, seeds_[2])), seeds_[0])
                        .inside();
    return -max(T(1.0) - square(apart * T(spacing_ / width_)), T(0.0));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 0}; }
  /// The parabola has the slope 2 at its rim; the difference has 2 per spacing.
  double lipschitz() const {
    return 2 * 2 / width_ *
           (1 + std::sqrt(2.0) * kBends * kGradientNoiseSlope * wander_ / spacing_);
  }

 private:
  static constexpr double kBends = 1.3;  // Waves of the deviation per spacing.
  Across across_;
  double spacing_, width_, wander_;
  uint32_t seeds_[3] = {};
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(anastomoses) {
  return noise_kind<Anastomoses>("anastomoses", [](const Anastomoses& a) { return Braid(a); });
}
