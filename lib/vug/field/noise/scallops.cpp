// SPDX-License-Identifier: Apache-2.0
// Scallops: hollows that turbulent water dissolves into a wall, modelled as a paraboloid about each
// of many points, meeting in sharp crests and steep on the upstream side (curl1974). The asymmetry
// results from moving each point along the flow by its own depth before the hollow is evaluated
// again.
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>

namespace vug::field {
namespace {

struct Scallops {
  double size = 0.2;
  Vec3d flow{1, 0, 0};
  double skew = 0.35;
  int seed = 1;

  static void describe(Schema<Scallops>& s) {
    s.doc("Hollows left by flowing water: -1 at their centres, crests between them.")
        .cite("curl1974")
        .param("size", &Scallops::size,
               positive_length("size of a hollow; faster water makes smaller ones"))
        .param("flow", &Scallops::flow, {.doc = "direction of the flow, of any length but 0"})
        .param("skew", &Scallops::skew,
               {.doc = "asymmetry: how much steeper the upstream side is", .min = 0, .max = 1})
        .param("seed", &Scallops::seed, {.doc = "random seed; each seed gives a different noise"});
  }
  std::string fault() const { return flow.length2() > 0 ? "" : "the flow must not be zero"; }
};

class Hollows {
 public:
  explicit Hollows(const Scallops& s)
      : size_(s.size),
        lean_(s.flow.normalized() * s.skew),
        skew_(s.skew),
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(s.seed)).at("scallops")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> q = p * T(1 / size_);
    const T deep = depth(q);
    const Point<T> moved{q.x + deep * T(lean_.x), q.y + deep * T(lean_.y), q.z + deep * T(lean_.z)};
    return depth(moved) * T(kDepth) - T(1.0);
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, kDepth - 1}; }
  double lipschitz() const { return kDepth * 2 * (1 + 2 * skew_) / size_; }

 private:
  /// 0 at a site, at most 1; slope at most 2.
  template <class T>
  T depth(const Point<T>& q) const {
    return min(nearest_sites(q, seed_).first.squared, T(1.0));
  }
  static constexpr double kDepth = 2.2;
  double size_;
  Vec3d lean_;
  double skew_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(scallops) {
  return noise_kind<Scallops>("scallops", [](const Scallops& s) { return Hollows(s); });
}
