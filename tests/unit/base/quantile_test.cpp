// SPDX-License-Identifier: Apache-2.0
#include <vug/base/quantile.h>

#include <gtest/gtest.h>

namespace vug {
namespace {

TEST(Quantile, IsAnElementOfTheSortedList) {
  const std::vector<double> values = {5, 1, 4, 2, 3};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.24), 1);
  EXPECT_EQ(quantile(values, 0.25), 2);
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.99), 4);
  EXPECT_EQ(quantile(values, 1), 5);
  EXPECT_EQ(quantile(std::vector<float>{7}, 0.3), 7.0f);
}

}  // namespace
}  // namespace vug
