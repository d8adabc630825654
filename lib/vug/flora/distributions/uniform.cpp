// SPDX-License-Identifier: Apache-2.0
// Independent uniform points: the binomial process for a fixed number of points, the Poisson
// process for a random one.
#include <vug/flora/distribution.h>

#include <cmath>

namespace vug::flora {
namespace {

struct Uniform {
  bool exact = true;

  static void describe(Schema<Uniform>& s) {
    s.doc("Independent uniform positions, like a tended stand of moso.")
        .param(
            "exact", &Uniform::exact,
            {.doc =
                 "exactly the number given by the density; else that number on average (Poisson)"});
  }
};

class UniformPoints final : public Distribution {
 public:
  explicit UniformPoints(const Uniform& p) : p_(p) {}

  std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                            Progress&) const override {
    require_density(density, plot.area());
    const double mean = density * plot.area();
    RandomStream number(key.at("number"));
    const uint64_t count =
        p_.exact ? static_cast<uint64_t>(std::llround(mean)) : poisson(mean, number);
    std::vector<Vec2d> points;
    points.reserve(count);
    for (uint64_t i = 0; i < count; ++i) {
      RandomStream random(key.at(i));
      points.push_back(plot.point(random));
    }
    return points;
  }

 private:
  Uniform p_;
};

}  // namespace
}  // namespace vug::flora

VUG_DISTRIBUTION_KIND(uniform) { return distribution_kind<Uniform, UniformPoints>("uniform"); }
