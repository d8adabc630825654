// SPDX-License-Identifier: Apache-2.0
// The regression around a pixel finds planes exactly, and means where nothing varies.
#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/image/local_regression.h>

#include <array>

namespace vug::image {
namespace {

TEST(LocalRegression, FindsAPlaneWhateverTheWeights) {
  LocalRegression fit(2, 4);
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 200; ++i) {
    std::array<float, 4> at{1};
    for (size_t k = 1; k < 4; ++k) at[k] = static_cast<float>(random.uniform(-1, 1));
    const float plane = 2 + 0.5f * at[1] - at[2] + 0.25f * at[3];
    const float values[3] = {plane, 2 * plane, 7};
    fit.add(1, static_cast<float>(random.uniform(0.01, 1)), at.data(), values);
  }
  float found[3];
  fit.solve(1, found);
  EXPECT_NEAR(found[0], 2, 0.005);
  EXPECT_NEAR(found[1], 4, 0.01);
  EXPECT_NEAR(found[2], 7, 1e-4);
}

TEST(LocalRegression, IsTheMeanWhereNoRegressorVaries) {
  LocalRegression fit(1, 3);
  const float at[3] = {1, 0, 0};
  for (int i = 0; i < 4; ++i) {
    const float values[3] = {static_cast<float>(i), 1, 0};
    fit.add(0, i == 3 ? 3.0f : 1.0f, at, values);
  }
  float found[3];
  fit.solve(0, found);
  EXPECT_NEAR(found[0], (0 + 1 + 2 + 3 * 3) / 6.0, 1e-6);
  EXPECT_NEAR(found[1], 1, 1e-6);
}

TEST(LocalRegression, OneNeighbourIsEnough) {
  LocalRegression fit(1, 10);
  const float at[10] = {1}, values[3] = {0.25f, 0.5f, 1e6f};
  fit.add(0, 0.3f, at, values);
  float found[3];
  fit.solve(0, found);
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], values[c], 1e-5f * values[c]);
}

TEST(LocalRegression, ExtrapolationsStayNearTheMean) {
  LocalRegression fit(1, 2);
  for (const float x : {2.0f, 3.0f}) {
    const float at[2] = {1, x};
    const float values[3] = {x - 2, 8 * (3 - x), 5};
    fit.add(0, 1, at, values);
  }
  float found[3];
  fit.solve(0, found);
  EXPECT_FLOAT_EQ(found[0], 0.5f / 4);  // The plane is -2 at 0.
  EXPECT_FLOAT_EQ(found[1], 4 * 4.0f);  // The plane is 24 at 0.
  EXPECT_NEAR(found[2], 5, 1e-4);
}

}  // namespace
}  // namespace vug::image
