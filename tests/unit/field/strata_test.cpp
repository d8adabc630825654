// SPDX-License-Identifier: Apache-2.0
// Displacement and strata: the range of the surface, and the properties of beds.
#include "random_point.h"

#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/displace.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

std::vector<std::pair<std::string, Field>> samples() {
  const Value ball = as_value(make("sphere", {{"radius", 2.0}}));
  const Value rough = as_value(make_noise("fbm", {{"scale", 0.7}}));
  return {
      {"plain", make("displace", {{"field", ball}, {"noise", rough}, {"amount", 0.2}})},
      {"by slope",
       make(
           "displace",
           {{"field", ball}, {"noise", rough}, {"amount", 0.3}, {"floor", 0.1}, {"ceiling", 1.5}})},
      {"by beds", make("displace", {{"field", ball},
                                    {"noise", rough},
                                    {"amount", 0.3},
                                    {"by", as_value(make_noise("beds"))}})},
      {"strata", make("strata", {{"field", ball}, {"normal", Vec3d(0.2, 1, 0)}})},
  };
}

TEST(Displace, EvaluationModesAgreeAndClaimsHold) {
  for (const auto& [name, f] : samples()) {
    RandomStream random(RandomKey(1));
    for (int i = 0; i < 3000; ++i) {
      const Vec3d p = random_point(random, 3), q = p + random_point(random, 0.01);
      ASSERT_LE(std::fabs(f.value(p) - f.value(q)), f.lipschitz() * (p - q).length()) << name;
      if (f.value(p) <= 0) {
        ASSERT_TRUE(f.bounds().intersects(p)) << name;
      }
    }
    for (int i = 0; i < 100; ++i) {
      const Ball ball{random_point(random, 3), 0.3};
      const Field::RestrictedField part = f.restricted(ball);
      for (int k = 0; k < 20; ++k) {
        const Vec3d p = ball.centre + random_point(random, 0.3 / std::sqrt(3.0));
        EXPECT_EQ(part.field.value(p), f.value(p)) << name;
        EXPECT_TRUE(part.range.contains(f.value(p))) << name;
        const Gradient g = f.gradient(p);
        const Vec3d step(0, 1e-6, 0);
        const double slope = (f.value(p + step) - f.value(p - step)) / 2e-6;
        EXPECT_NEAR(g.gradient.y, slope, 2e-3 * (1 + f.lipschitz())) << name;
      }
    }
  }
}

TEST(Displace, FactorsFollowTheFacing) {
  // A constant noise would move floors, walls and ceilings by their factors. Beds of one mean
  // thickness are not constant, so the displacement is compared with the noise itself, far from
  // edges.
  const Field slab = transformed(make("sphere", {{"radius", 1e4}}),
                                 Transform::translation({0, -1e4, 0}));  // A floor at y = 0.
  const Noise rough = make_noise("fbm");
  Displacement how;
  how.amount = 0.5;
  how.floor = 0.25;
  how.wall = 3;
  how.ceiling = 7;
  const Field floor = displaced(slab, rough, how);
  const Field ceiling = displaced(complement(slab), rough, how);
  const Vec3d p(0.3, 0.1, 0.2);
  EXPECT_NEAR(slab.value(p) - floor.value(p), 0.5 * 0.25 * rough.field.value(p), 1e-6);
  EXPECT_NEAR(-slab.value(p) - ceiling.value(p), 0.5 * 7 * rough.field.value(p), 1e-6);
}

TEST(Strata, AreConstantAlongTheBeds) {
  const Vec3d normal(0.3, 1, -0.2);
  const Noise beds = make_noise("beds", {{"normal", normal}, {"wander", 0.0}});
  const Vec3d along = normal.cross({0, 0, 1}).normalized();
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 10);
    EXPECT_NEAR(beds.field.value(p), beds.field.value(p + random.uniform(-5, 5) * along), 1e-11);
  }
}

TEST(Strata, BedsHaveTheRequestedMeanThicknessAndHardnessIsUniform) {
  const Noise beds = make_noise("beds", {{"thickness", 0.5}, {"wander", 0.0}, {"laminae", 0.0}});
  int partings = 0, hard = 0, soft = 0;
  double before = beds.field.value({0, 0, 0}), value = before;
  for (int i = 1; i < 400000; ++i) {  // 400 m in steps of a millimetre.
    const double next = beds.field.value({0, i * 1e-3, 0});
    if (std::fabs(value) < std::fabs(before) && std::fabs(value) <= std::fabs(next)) ++partings;
    (next > 0 ? hard : soft)++;
    before = value;
    value = next;
  }
  EXPECT_NEAR(partings, 800, 5);  // The value is closest to 0 once at each.
  EXPECT_NEAR(hard / 4e5, 0.5, 0.07);
}

}  // namespace
}  // namespace vug::field
