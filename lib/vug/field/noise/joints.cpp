// SPDX-License-Identifier: Apache-2.0
// A set of joints: nearly parallel cracks at irregular distances, each with its own depth.
#include <vug/base/rng.h>
#include <vug/field/bedding.h>
#include <vug/field/noise_node.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Joints {
  double spacing = 1.5;
  Vec3d normal{1, 0, 0.3};
  double width = 0.08;
  double wander = 0.15;
  double reach = 3;
  int seed = 1;

  static void describe(Schema<Joints>& s) {
    s.doc("Cracks along nearly parallel planes: down to -1 in a crack, 0 between them.")
        .param("spacing", &Joints::spacing, positive_length("mean distance between cracks"))
        .param("normal", &Joints::normal,
               {.doc = "perpendicular to the cracks, of any length but 0"})
        .param("width", &Joints::width, positive_length("width of a crack at its mouth"))
        .param("wander", &Joints::wander,
               {.doc = "deviation of the cracks from planes",
                .dimension = Dimension::length,
                .min = 0})
        .param("reach", &Joints::reach, positive_length("wavelength of the deviation"))
        .param("seed", &Joints::seed, {.doc = "random seed; each seed gives different cracks"});
  }
  std::string fault() const {
    if (width >= kThinnestBed * spacing)
      return "the width of joints must be below a fifth of their spacing, otherwise they merge";
    return normal.length2() > 0 ? "" : "the normal must not be zero";
  }
};

class Cracks {
 public:
  explicit Cracks(const Joints& j) : half_(0.5 * j.width / j.spacing) {
    RandomStream random(RandomKey(static_cast<uint64_t>(j.seed)).at("joints"));
    layering_ = {j.normal.normalized(), j.spacing, j.wander, j.reach, random.bits()};
  }

  template <class T>
  T at(const Point<T>& p) const {
    const Bed<T> bed = bed_at(layering_.height(p), layering_.seed);
    auto groove = [&](const T& distance, const T& index) {
      const T depth = lattice_random(index, layering_.seed ^ 0x2545f491u) * T(0.8) + T(0.2);
      return depth * square(max(T(1.0) - distance * T(1 / half_), T(0.0)));
    };
    return -max(groove(bed.below, bed.index), groove(bed.above, bed.index + T(1.0)));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 0}; }
  double lipschitz() const { return layering_.slope() * 2 / half_; }

 private:
  double half_;  // Half of a crack's width, in spacings.
  Layering layering_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(joints) {
  return noise_kind<Joints>("joints", [](const Joints& j) { return Cracks(j); });
}
