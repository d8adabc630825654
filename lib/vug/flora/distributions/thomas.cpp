// SPDX-License-Identifier: Apache-2.0
// The Thomas process: stems normally distributed about the centre of their clump. Its K(r) = pi r^2
// + (1 - exp(-r^2 / (4 spread^2))) / clumps per area (cite illian2008, 6.3).
#include <vug/flora/cluster_process.h>

namespace vug::flora {
namespace {

struct Thomas {
  double per_clump = 12;
  double spread = 0.6;

  static void describe(Schema<Thomas>& s) {
    s.doc("Clumps that are dense in the middle and thin out, like bamboo in tufts.")
        .cite("thomas1949")
        .param("per_clump", &Thomas::per_clump,
               {.doc = "mean number of stems per clump", .min = 0, .max = 1e6, .above_min = true})
        .param("spread", &Thomas::spread,
               positive_length("standard deviation of a stem's offset along x and z"));
  }
};

class ThomasPoints final : public Distribution {
 public:
  explicit ThomasPoints(const Thomas& p) : p_(p) {}

  std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                            Progress& progress) const override {
    // 1.5e-8 of the stems lie beyond 6 spreads; they are kept where normal() puts them.
    return cluster_points(plot, density, key, progress,
                          {p_.per_clump, 6 * p_.spread, [this](RandomStream& random) {
                             const double x = random.normal();
                             return Vec2d(x, random.normal()) * p_.spread;
                           }});
  }

 private:
  Thomas p_;
};

}  // namespace
}  // namespace vug::flora

VUG_DISTRIBUTION_KIND(thomas) { return distribution_kind<Thomas, ThomasPoints>("thomas"); }
