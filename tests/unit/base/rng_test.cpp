// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vug {
namespace {

// Known answers published with Random123 (Salmon et al. 2011), kat_vectors.
TEST(Philox, MatchesPublishedVectors) {
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (std::array<uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u}),
            (std::array<uint32_t, 4>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(RandomKey, PathsDoNotCollide) {
  std::set<uint64_t> seen;
  const RandomKey root(2012);
  for (const char* name : {"a", "b", "ab", "room", "melt", ""}) seen.insert(root.at(name).state());
  for (uint64_t i = 0; i < 1000; ++i) seen.insert(root.at(i).state());
  seen.insert(root.at("a").at("b").state());
  EXPECT_EQ(seen.size(), 1007u);
}

TEST(RandomStream, UniformHasTheRightMoments) {
  RandomStream random(RandomKey(7).at("moments"));
  const int n = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 4 * 0.2887 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 4 * 0.298 / std::sqrt(n));
}

TEST(RandomStream, BelowIsUniform) {
  RandomStream random(RandomKey(7).at("below"));
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts[random.below(7)];
  double chi2 = 0;
  for (const int count : counts) chi2 += (count - 10000.0) * (count - 10000.0) / 10000.0;
  EXPECT_LT(chi2, 22.5);  // 6 degrees of freedom, p = 0.001
}

TEST(RandomStream, NormalHasTheRightMoments) {
  RandomStream random(RandomKey(7).at("normal"));
  const int n = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double z = random.normal();
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / n, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 4 * std::sqrt(2.0 / n));
}

}  // namespace
}  // namespace vug
