// SPDX-License-Identifier: Apache-2.0
// Matern's cluster process: stems distributed uniformly over a disk about the centre of their clump
// (cite matern1960; its K function: illian2008, 6.3).
#include <vug/base/maths.h>
#include <vug/flora/cluster_process.h>

#include <cmath>

namespace vug::flora {
namespace {

struct Matern {
  double per_clump = 12;
  double radius = 1.2;

  static void describe(Schema<Matern>& s) {
    s.doc("Clumps with a sharp edge: round tufts, as dense at the rim as in the middle.")
        .cite("matern1960")
        .param("per_clump", &Matern::per_clump,
               {.doc = "mean number of stems per clump", .min = 0, .max = 1e6, .above_min = true})
        .param("radius", &Matern::radius, positive_length("of a clump"));
  }
};

class MaternPoints final : public Distribution {
 public:
  explicit MaternPoints(const Matern& p) : p_(p) {}

  std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                            Progress& progress) const override {
    return cluster_points(plot, density, key, progress,
                          {p_.per_clump, p_.radius, [this](RandomStream& random) {
                             const double r = p_.radius * std::sqrt(random.uniform());
                             const double angle = 2 * kPi * random.uniform();
                             return Vec2d(maths::cos(angle), maths::sin(angle)) * r;
                           }});
  }

 private:
  Matern p_;
};

}  // namespace
}  // namespace vug::flora

VUG_DISTRIBUTION_KIND(matern) { return distribution_kind<Matern, MaternPoints>("matern"); }
