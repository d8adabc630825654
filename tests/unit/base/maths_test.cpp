#include <vug/base/hyperbolic.h>
#include <vug/base/maths.h>
#include <vug/base/rng.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

// The C library is the oracle; it may differ between machines in the last bit, ours may not.
TEST(Maths, AgreesWithTheLibrary) {
  RandomStream random(RandomKey(1).at("maths"));
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-1000, 1000);
    EXPECT_NEAR(maths::sin(x), std::sin(x), 4e-16) << x;
    EXPECT_NEAR(maths::cos(x), std::cos(x), 4e-16) << x;
    const double e = random.uniform(-700, 700);
    EXPECT_NEAR(maths::exp(e) / std::exp(e), 1, 1e-15) << e;
    const double y = random.uniform(-5, 5), z = random.uniform(-5, 5);
    EXPECT_NEAR(maths::atan2(y, z), std::atan2(y, z), 1e-15);
    const double p = std::exp(random.uniform(-20, 20));
    EXPECT_NEAR(maths::log(p), std::log(p), 1e-15 * (1 + std::fabs(std::log(p)))) << p;
    const double c = random.uniform(-1, 1);
    EXPECT_NEAR(maths::acos(c), std::acos(c), 1e-15);
  }
}

TEST(Maths, HyperbolicFunctionsAgreeWithTheLibrary) {
  RandomStream random(RandomKey(1).at("hyperbolic"));
  for (int i = 0; i < 20000; ++i) {
    const double x = std::pow(10, random.uniform(-6, 1.4)) * (i % 2 ? 1 : -1);
    EXPECT_NEAR(maths::tanh(x) / std::tanh(x), 1, 5e-16) << x;
    const double y = std::pow(10, random.uniform(-6, -1e-4)) * (i % 2 ? 1 : -1);
    EXPECT_NEAR(maths::atanh(y) / std::atanh(y), 1, 1e-15) << y;
  }
  EXPECT_EQ(maths::tanh(0), 0);
  EXPECT_EQ(maths::tanh(-1000), -1);
  EXPECT_EQ(maths::atanh(1), INFINITY);
  EXPECT_TRUE(std::isnan(maths::atanh(1.5)));
}

TEST(Maths, EdgesAreRight) {
  EXPECT_EQ(maths::log(0), -INFINITY);
  EXPECT_TRUE(std::isnan(maths::log(-1)));
  EXPECT_EQ(maths::exp(1000), INFINITY);
  EXPECT_EQ(maths::atan2(0, 0), 0);
  EXPECT_EQ(maths::pow(2, 10), 1024);
  EXPECT_EQ(maths::pow(0, 2), 0);
}

}  // namespace
}  // namespace vug
