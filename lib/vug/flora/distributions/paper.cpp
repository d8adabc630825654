// SPDX-License-Identifier: Apache-2.0
// Random weighted means of the corners, the paper's random distribution in a convex polygon. It is
// not uniform: points crowd in the middle.
#include <vug/flora/distribution.h>
#include <vug/flora/weighted_point.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::flora {
namespace {

struct Paper {
  std::vector<double> weights = {0, 1};

  static void describe(Schema<Paper>& s) {
    s.doc(
         "As in the paper: random weighted means of the corners. Plants crowd in the middle of a "
         "convex polygon.")
        .cite("luo2010bamboo")
        .param("weights", &Paper::weights,
               {.doc = "range of the random weights, excluding the lower limit", .min = 0});
  }
  std::string fault() const {
    return weights.size() != 2 || !(weights[0] < weights[1])
               ? "'weights' must be two numbers, the smaller one first"
               : "";
  }
};

class PaperPoints final : public Distribution {
 public:
  explicit PaperPoints(const Paper& p) : p_(p) {}

  std::vector<Vec2d> points(const Plot& plot, double density, RandomKey key,
                            Progress&) const override {
    require_density(density, plot.area());
    if (const int reflex = plot.first_reflex_corner(); reflex >= 0)
      throw Error(
          ErrorCode::bad_input,
          fmt::format("the paper's distribution needs a convex polygon; corner {} at {} is concave",
                      reflex + 1, to_string(plot.corners()[static_cast<size_t>(reflex)])),
          {}, "use another distribution: they take any simple polygon");
    const auto count = static_cast<uint64_t>(std::llround(density * plot.area()));
    std::vector<Vec2d> points;
    points.reserve(count);
    std::vector<double> weights(plot.corners().size());
    for (uint64_t i = 0; i < count; ++i) {
      RandomStream random(key.at(i));
      for (double& weight : weights)
        weight = p_.weights[1] - (p_.weights[1] - p_.weights[0]) * random.uniform();
      points.push_back(weighted_point(plot.corners(), weights));
    }
    return points;
  }

 private:
  Paper p_;
};

}  // namespace
}  // namespace vug::flora

VUG_DISTRIBUTION_KIND(paper) { return distribution_kind<Paper, PaperPoints>("paper"); }
