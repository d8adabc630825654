// SPDX-License-Identifier: Apache-2.0
// Convergence diagnostics compared with processes of known values.
#include <vug/base/rng.h>
#include <vug/inference/convergence.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::inference {
namespace {

/// x <- a x + noise: its autocorrelation time is (1 + a) / (1 - a).
Trace autoregression(double a, size_t steps, uint64_t seed, double middle = 0) {
  RandomStream stream{RandomKey(seed)};
  Trace out;
  double x = 0;
  for (size_t i = 0; i < steps; ++i) {
    x = a * x + std::sqrt(1 - a * a) * stream.normal();
    out.push_back(middle + x);
  }
  return out;
}

TEST(Convergence, AutocorrelationTimesOfAutoregressions) {
  for (const double a : {0.0, 0.5, 0.9}) {
    const double time = (1 + a) / (1 - a);
    EXPECT_NEAR(autocorrelation_time(autoregression(a, 100000, 3)), time, 0.15 * time) << a;
  }
  EXPECT_NEAR(effective_size(autoregression(0.5, 30000, 3)), 10000, 1000);
  EXPECT_EQ(autocorrelation_time(Trace(100, 2.0)), 1);
  EXPECT_EQ(autocorrelation_time({}), 1);
}

TEST(Convergence, TracesOfOneDistributionAgree) {
  const std::vector<Trace> same = {autoregression(0.5, 5000, 1), autoregression(0.5, 5000, 2)};
  EXPECT_NEAR(scale_reduction(same), 1, 0.01);
  const std::vector<Trace> apart = {same[0], autoregression(0.5, 5000, 2, 3)};
  EXPECT_GT(scale_reduction(apart), 1.5);
  Trace drifting = same[0];
  for (size_t i = 0; i < drifting.size(); ++i) drifting[i] += 1e-3 * static_cast<double>(i);
  EXPECT_GT(scale_reduction({drifting}), 1.5) << "its halves differ";
  EXPECT_EQ(scale_reduction({Trace(10, 1.0), Trace(10, 1.0)}), 1);
}

TEST(Convergence, BurnInIsDetected) {
  EXPECT_LT(std::abs(geweke(autoregression(0.5, 5000, 1))), 3);
  Trace late = autoregression(0.5, 5000, 1);
  for (size_t i = 0; i < 500; ++i) late[i] += 1;
  EXPECT_GT(geweke(late), 5);
  EXPECT_EQ(geweke(Trace(100, 2.0)), 0);
  EXPECT_EQ(geweke({}), 0);
}

}  // namespace
}  // namespace vug::inference
