// SPDX-License-Identifier: Apache-2.0
// Scallops: hollows that turbulent water dissolves into a wall. They meet in sharp crests, and the
// upstream wall of each hollow is the steep one.
#include <vug/base/rng.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/frame.h>
#include <vug/field/speleogens/scallop_length.h>
#include <vug/field/speleogens/scallop_pits.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Scallops {
  double size = 0.8;
  double velocity = 0;
  double diameter = 2;
  Vec3d flow{1, 0, 0};
  double ratio = 1;
  int seed = 1;

  static void describe(Schema<Scallops>& s) {
    s.doc(
         "Hollows left by flowing water: about -1 at their deepest points, crests near 0 between "
         "them. Their upstream walls are steep. Real ones are an eighth as deep as long: use an "
         "amount of size / 8.")
        .cite("blumberg1974")
        .cite("curl1974")
        .param("size", &Scallops::size,
               positive_length("mean length of a hollow, 1 cm to 1 m in caves; faster water makes "
                               "smaller ones"))
        .param("velocity", &Scallops::velocity,
               {.doc = "mean velocity of water of 10 degrees in m/s, which replaces 'size'; 0: not "
                       "used. 0.66 m/s in a tube of 1 m make scallops of 5 cm",
                .min = 0,
                .max = 20})
        .param("diameter", &Scallops::diameter,
               positive_length("diameter of the passage that the water fills, for 'velocity'"))
        .param("flow", &Scallops::flow, {.doc = "direction of the flow, of any length but 0"})
        .param("ratio", &Scallops::ratio,
               {.doc = "width of a hollow over its length: 1 for scallops, 3 and more for flutes",
                .min = 0.3,
                .max = 20})
        .param("seed", &Scallops::seed, {.doc = "random seed; each seed gives a different noise"});
  }
  std::string fault() const {
    if (!(flow.length2() > 0)) return "the flow must not be zero";
    if (velocity > 0 && !scallop_length(velocity, diameter))
      return "water of this velocity makes no scallops in a passage of this diameter; use a higher "
             "velocity or a larger diameter";
    return "";
  }
  double length() const { return velocity > 0 ? *scallop_length(velocity, diameter) : size; }
};

class Hollows {
 public:
  explicit Hollows(const Scallops& s)
      : frame_(s.flow, {1 / s.length(), 1 / (s.length() * s.ratio), 1 / (s.length() * s.ratio)}),
        lipschitz_(kScale * kSteepest * std::max(1.0, 1 / s.ratio) / s.length()),
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(s.seed)).at("scallops")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    const T depth = deepest_scallop(frame_.local(p), seed_).depth();
    return max(depth, T(-kScallopRim)) * T(-kScale);
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const {
    return {-kScale * kScallopDepth * kLongestScallop, kScale * kScallopRim};
  }
  double lipschitz() const { return lipschitz_; }

 private:
  /// With an amount of an eighth of the length, hollows are 1.04 times as deep as the profile,
  /// which replaces the depth that crests between hollows of unequal depth lose.
  static constexpr double kScale = 8 * 1.04;
  /// Along the flow the slope P' of the profile P, across it (2 (rim / length + P))^1/2.
  static constexpr double kSteepest = 0.86;
  FlowFrame frame_;
  double lipschitz_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(scallops) {
  return noise_kind<Scallops>("scallops", [](const Scallops& s) { return Hollows(s); });
}
