// SPDX-License-Identifier: Apache-2.0
// Superposition of several independent processes in one plot.
#include <vug/flora/distribution.h>

#include <algorithm>

namespace vug::flora {
namespace {

struct Mixed {
  std::vector<DistributionPtr> of;
  std::vector<double> shares;

  static void describe(Schema<Mixed>& s) {
    s.doc("Several distributions at once, for example single stems between clumps.")
        .param("of", &Mixed::of, {.doc = "the distributions; none: uniform and thomas"})
        .param("shares", &Mixed::shares, {.doc = "relative densities; none: equal", .min = 0});
  }
  std::string fault() const {
    if (!shares.empty() && shares.size() != (of.empty() ? 2 : of.size()))
      return "'shares' must have one number per distribution, or none";
    return !shares.empty() &&
                   std::all_of(shares.begin(), shares.end(), [](double s) { return s == 0; })
               ? "one of the 'shares' must be above 0"
               : "";
  }
};

class MixedPoints final : public Distribution {
 public:
  explicit MixedPoints(const Mixed& p) : p_(p) {
    if (p_.of.empty())
      for (const char* name : {"uniform", "thomas"})
        p_.of.push_back(make_product(distributions(), name));
    if (p_.shares.empty()) p_.shares.assign(p_.of.size(), 1);
    for (const double share : p_.shares) total_ += share;
  }

  std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                            Progress& progress) const override {
    require_density(density, plot.area());
    std::vector<Vec2d> points;
    for (size_t i = 0; i < p_.of.size(); ++i) {
      if (p_.shares[i] == 0) continue;
      const std::vector<Vec2d> own =
          p_.of[i]->points(plot, density * p_.shares[i] / total_, key.at(i), progress);
      points.insert(points.end(), own.begin(), own.end());
    }
    return points;
  }

 private:
  Mixed p_;
  double total_ = 0;
};

}  // namespace
}  // namespace vug::flora

VUG_DISTRIBUTION_KIND(mixed) { return distribution_kind<Mixed, MixedPoints>("mixed"); }
