// SPDX-License-Identifier: Apache-2.0
// Cellular noise (worley1996) from the distances F1 <= F2 to the two nearest random points, with
// one point per cell.
#include <vug/base/rng.h>
#include <vug/field/factors.h>
#include <vug/field/lattice.h>
#include <vug/field/noise_node.h>

#include <algorithm>

namespace vug::field {
namespace {

enum class Pattern { bumps, plates, cracks };

struct Worley {
  Pattern pattern = Pattern::bumps;
  Factors scale;
  double width = 0.15;
  int seed = 1;

  static void describe(Schema<Worley>& s) {
    s.doc("Cells around random points.")
        .cite("worley1996")
        .choice(
            "pattern", &Worley::pattern,
            {{"bumps", Pattern::bumps}, {"plates", Pattern::plates}, {"cracks", Pattern::cracks}},
            "bumps: 1 - 2 F1, cobbles; plates: 2 (F2 - F1) - 0.6, slabs with sunken borders; "
            "cracks: -1 along the borders, 0 elsewhere")
        .param("scale", &Worley::scale,
               {.doc = "size of the cells; a vector stretches them along the axes",
                .dimension = Dimension::length,
                .min = 0,
                .above_min = true})
        .param("width", &Worley::width,
               {.doc = "width of a crack as a fraction of the cell size",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1,
                .above_min = true})
        .param("seed", &Worley::seed, {.doc = "random seed; each seed gives a different noise"});
  }
};

class Cells {
 public:
  explicit Cells(const Worley& w)
      : w_(w), seed_(RandomStream(RandomKey(static_cast<uint64_t>(w.seed)).at("worley")).bits()) {}

  template <class T>
  T at(const Point<T>& p) const {
    const Vec3d& s = w_.scale.each;
    const auto sites =
        nearest_sites(Point<T>{p.x * T(1 / s.x), p.y * T(1 / s.y), p.z * T(1 / s.z)}, seed_);
    const T f1 = sqrt(sites.first.squared);
    if (w_.pattern == Pattern::bumps) return T(1.0) - f1 * T(2.0);
    const T apart = sqrt(sites.second.squared) - f1;
    if (w_.pattern == Pattern::plates) return apart * T(2.0) - T(0.6);
    return min(apart * T(1 / w_.width), T(1.0)) - T(1.0);
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  /// A cell's own point is at most sqrt(3) away, the second one, in the next cell, at most sqrt(6).
  Interval range() const {
    if (w_.pattern == Pattern::bumps) return {1 - 2 * 1.7321, 1};
    if (w_.pattern == Pattern::plates) return {-0.6, 2 * 2.4495 - 0.6};
    return {-1, 0};
  }
  double lipschitz() const {
    const Vec3d& s = w_.scale.each;
    const double slope = w_.pattern == Pattern::bumps    ? 2
                         : w_.pattern == Pattern::plates ? 4
                                                         : 2 / w_.width;
    return slope / std::min({s.x, s.y, s.z});
  }

 private:
  Worley w_;
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(worley) {
  return noise_kind<Worley>("worley", [](const Worley& w) { return Cells(w); });
}
