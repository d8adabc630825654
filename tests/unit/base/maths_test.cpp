// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hyperbolic.h>
#include <vug/base/maths.h>
#include <vug/base/rng.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

// The C library is the oracle; its results may differ between machines in the last bit, those of
// maths.h must not.
TEST(Maths, MatchesTheCLibrary) {
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

TEST(Maths, HyperbolicFunctionsMatchTheCLibrary) {
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

// The library's powers are accurate to 0.52 ulp, so both are usually the nearest representable
// number.
TEST(Maths, PowersMatchTheCLibraryToAlmostAllDigits) {
  RandomStream random(RandomKey(1).at("power"));
  const int count = 20000;
  int others = 0;
  for (int i = 0; i < count; ++i) {
    const double base = i % 2 ? random.uniform(0, 4) : std::exp(random.uniform(-100, 100));
    const double exponent = random.uniform(-6, 6);
    const double library = std::pow(base, exponent), ours = maths::pow(base, exponent);
    EXPECT_NEAR(ours / library, 1, 2.3e-16) << base << " ^ " << exponent;
    others += ours != library;
    EXPECT_NEAR(maths::pow(base, 0.5) / std::sqrt(base), 1, 2.3e-16) << base;
  }
  EXPECT_LT(others, count / 100);
}

TEST(Maths, EdgeCasesAreCorrect) {
  EXPECT_EQ(maths::log(0), -INFINITY);
  EXPECT_TRUE(std::isnan(maths::log(-1)));
  EXPECT_EQ(maths::exp(1000), INFINITY);
  EXPECT_EQ(maths::atan2(0, 0), 0);
  EXPECT_EQ(maths::pow(2, 10), 1024);
  EXPECT_EQ(maths::pow(0, 2), 0);
  EXPECT_EQ(maths::pow(3, 0.5), 1.7320508075688772);
  EXPECT_EQ(maths::pow(1e308, 1.1), INFINITY);
  EXPECT_EQ(maths::pow(1e-308, 1.5), 0);
  EXPECT_NEAR(maths::pow(1e-200, 1.6) / 1e-320, 1, 1e-3);  // a subnormal number
  EXPECT_NEAR(maths::pow(1e-310, 0.5) / 1e-155, 1, 1e-9);
  EXPECT_EQ(maths::pow(1, 1e300), 1);
  EXPECT_TRUE(std::isnan(maths::pow(-2, 0.5)));
}

}  // namespace
}  // namespace vug
