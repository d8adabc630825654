// SPDX-License-Identifier: Apache-2.0
// Cross-bedded sandstone: dunes that moved over each other left sets of inclined laminae, each cut
// off by the flat base of the next.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/cross_beds.h>

namespace vug::field {
namespace {

struct CrossBedding {
  double thickness = 0.6;
  double lamina = 0.04;
  Vec3d flow{1, 0, 0};
  Vec3d normal{0, 1, 0};
  double steep = 34 * kPi / 180;
  double gentle = 20 * kPi / 180;
  double spread = 25 * kPi / 180;
  double contrast = 0.5;
  int seed = 1;

  static void describe(Schema<CrossBedding>& s) {
    const ParamSpec dip{
        .doc = "", .dimension = Dimension::angle, .min = 5 * kPi / 180, .max = 45 * kPi / 180};
    auto angle = [&](std::string doc) {
      ParamSpec out = dip;
      out.doc = std::move(doc);
      return out;
    };
    s.doc(
         "Cross-bedded sandstone: 1 on the hardest laminae, -1 in the grooves of the softest. The "
         "laminae of a set dip down the wind, flatten towards its base and end at the base of the "
         "next set, which cuts them off.")
        .cite("mckee1953")
        .param("thickness", &CrossBedding::thickness, positive_length("mean thickness of a set"))
        .param("lamina", &CrossBedding::lamina, positive_length("mean thickness of a lamina"))
        .param("flow", &CrossBedding::flow,
               {.doc = "direction of the wind or water that moved the dunes: laminae dip that way"})
        .param("normal", &CrossBedding::normal,
               {.doc = "perpendicular to the sets, of any length but 0"})
        .param("steep", &CrossBedding::steep,
               angle("largest dip of laminae at the top of a set, the angle of repose"))
        .param("gentle", &CrossBedding::gentle, angle("smallest dip of laminae there"))
        .param("spread", &CrossBedding::spread,
               {.doc = "largest angle between the dip of a set and the direction of the flow",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi})
        .param("contrast", &CrossBedding::contrast,
               {.doc = "difference in hardness between sets over that between all laminae",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("seed", &CrossBedding::seed, {.doc = "random seed; each seed gives other sets"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal must not be zero";
    if (!(flow.cross(normal).length2() > 1e-12 * flow.length2() * normal.length2()))
      return "the flow must not be along the normal of the sets";
    if (!(gentle <= steep)) return "'gentle' must not exceed 'steep'";
    return lamina < 0.5 * thickness ? "" : "a lamina must be thinner than half of a set";
  }
};

class Laminae {
 public:
  explicit Laminae(const CrossBedding& c)
      : beds_({c.thickness, c.lamina, c.flow, c.normal, c.steep, c.gentle, c.spread},
              RandomStream(RandomKey(static_cast<uint64_t>(c.seed)).at("cross_bedding")).bits()),
        contrast_(c.contrast) {}

  template <class T>
  T at(const Point<T>& p) const {
    const CrossBed<T> here = beds_.at(p);
    // A hard lamina is a rib, a soft one a groove; both are 0 at their boundaries.
    const T half = (here.lamina.below + here.lamina.above) * T(0.5);
    const T bulge = here.lamina.below * here.lamina.above / square(half);
    const T set = here.set_random * T(2.0) - T(1.0);
    const T own = here.lamina_random * T(2.0) - T(1.0);
    const T hardness = set * T(contrast_) + own * T(1 - contrast_);
    // Bases of sets are partings.
    const T off = min(here.from_base * T(1 / CrossBeds::kParting), T(1.0));
    return hardness * bulge * off;
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 1}; }
  /// The bulge rises by 4 per thinnest lamina.
  double lipschitz() const {
    return beds_.lamina_slope() * 4 / kThinnestBed + beds_.base_slope() / CrossBeds::kParting;
  }

 private:
  CrossBeds beds_;
  double contrast_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(cross_bedding) {
  return noise_kind<CrossBedding>("cross_bedding",
                                  [](const CrossBedding& c) { return Laminae(c); });
}
