// As many points as asked for, each anywhere alike: the binomial process, or with a number that is
// itself by chance the Poisson process.
#include <vug/flora/distribution.h>

#include <cmath>

namespace vug::flora {
namespace {

struct Uniform {
  bool exact = true;

  static void describe(Schema<Uniform>& s) {
    s.doc("Each plant anywhere alike: a tended stand of moso.")
        .param("exact", &Uniform::exact,
               {.doc = "as many as the density says; else that many on average (Poisson)"});
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
