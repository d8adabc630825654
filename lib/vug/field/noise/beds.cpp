// SPDX-License-Identifier: Apache-2.0
// Layered hardness: the weathered profile of a stack of beds. A hard bed protrudes as a ledge,
// sharp below and worn on top; a soft bed recedes as a round notch; every boundary is a parting at
// 0. Thin laminae repeat the pattern within the beds with less strength.
#include <vug/base/rng.h>
#include <vug/field/bedding.h>
#include <vug/field/beds.h>
#include <vug/field/noise_node.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Beds : BedParams {
  static void describe(Schema<Beds>& s) {
    describe_beds(
        s.doc("Layered rock: 1 on the face of the hardest bed, -1 in the notch of the softest."));
  }
  void add_to(Digester& digester) const { digester(static_cast<const BedParams&>(*this)); }
};

class Hardness {
 public:
  explicit Hardness(const BedParams& b) : ledge_(b.ledge), laminae_(b.laminae) {
    RandomStream random(RandomKey(static_cast<uint64_t>(b.seed)).at("beds"));
    coarse_ = {b.normal.normalized(), b.thickness, b.wander, b.reach, random.bits()};
    fine_seed_ = random.bits();
  }

  template <class T>
  T at(const Point<T>& p) const {
    const T u = coarse_.height(p);
    const T value = profile(u, coarse_.seed);
    if (laminae_ == 0) return value;
    return (value + profile(u * T(kFiner), fine_seed_) * T(laminae_)) * T(1 / (1 + laminae_));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 1}; }
  double lipschitz() const {
    // The foot of a ledge is the steepest part: 2 per width; a notch rises by 4 per bed.
    const double foot = std::min(kFoot * ledge_, 0.5 * kThinnestBed);
    const double steepest = std::max(2 / foot, 4 / kThinnestBed);
    return coarse_.slope() * steepest * (1 + kFiner * laminae_) / (1 + laminae_);
  }

 private:
  static constexpr double kFiner = 4.7, kFoot = 0.5, kShoulder = 2;

  template <class T>
  T profile(const T& u, uint32_t seed) const {
    const Bed<T> bed = bed_at(u, seed);
    const T hardness = lattice_random(bed.index, seed ^ 0x68bc21ebu) * T(2.0) - T(1.0);
    const T half = (bed.below + bed.above) * T(0.5);
    auto rise = [](const T& distance, const T& width) {
      const T t = min(distance / width, T(1.0));
      return t * (T(2.0) - t);
    };
    const T hard = rise(bed.below, min(T(kFoot * ledge_), half)) *
                   rise(bed.above, min(T(kShoulder * ledge_), half));
    const T soft = bed.below * bed.above / square(half);
    return hardness * select(hardness > T(0.0), hard, soft);
  }

  double ledge_, laminae_;
  Layering coarse_;
  uint32_t fine_seed_ = 0;
};

}  // namespace

Noise layered_rock(const BedParams& params) {
  return formula_noise("beds", Hardness(params), params);
}

}  // namespace vug::field

VUG_NOISE_KIND(beds) { return make_kind<Noise, Beds>("beds", "noise", layered_rock); }
