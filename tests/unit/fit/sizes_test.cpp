// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/fit/model/sizes.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::fit {
namespace {

SizeGains random_gains(uint64_t seed, size_t cells) {
  RandomStream stream{RandomKey(seed)};
  SizeGains out{{4, 5}, {7, 8}, {}};
  for (size_t cell = 0; cell < cells; ++cell) {
    std::vector<double>& sizes = out.cells.emplace_back();
    for (size_t size = 0; size < out.count(); ++size) sizes.push_back(10 * stream.uniform() - 4);
  }
  return out;
}

/// Total gain if each cell has the best of the sizes.
double gain_of(const SizeGains& gains, const std::vector<size_t>& sizes) {
  double out = 0;
  for (const std::vector<double>& cell : gains.cells) {
    double best = 0;
    for (const size_t size : sizes) best = std::max(best, cell[size]);
    out += best;
  }
  return out;
}

std::vector<size_t> places(const SizeGains& gains, const SizeChoice& choice) {
  std::vector<size_t> out;
  for (const WindowSize& wanted : choice.sizes)
    for (size_t at = 0; at < gains.count(); ++at)
      if (gains.size(at) == wanted) out.push_back(at);
  return out;
}

TEST(Sizes, CellsHaveTheirBestSizeAndTheGainIsConsistent) {
  const SizeGains gains = random_gains(1, 20);
  const std::vector<SizeChoice> choices = choose_sizes(gains, 5, 0);
  ASSERT_EQ(choices.size(), 5u);
  for (size_t k = 0; k < choices.size(); ++k) {
    ASSERT_EQ(choices[k].sizes.size(), k + 1);
    const std::vector<size_t> sizes = places(gains, choices[k]);
    ASSERT_EQ(sizes.size(), k + 1);
    double sum = 0;
    for (size_t cell = 0; cell < gains.cells.size(); ++cell)
      if (const int of = choices[k].kinds[cell])
        sum += gains.cells[cell][sizes[static_cast<size_t>(of) - 1]];
    EXPECT_NEAR(sum, choices[k].gain, 1e-9);
    EXPECT_NEAR(gain_of(gains, sizes), choices[k].gain, 1e-9);
  }
}

/// Pairs are nearly always optimal, and no exchange of one size is better.
TEST(Sizes, PairsAreMostlyOptimal) {
  int best = 0;
  constexpr int kTimes = 100;
  for (uint64_t seed = 0; seed < kTimes; ++seed) {
    const SizeGains gains = random_gains(seed, 12);
    const std::vector<SizeChoice> choices = choose_sizes(gains, 2, 0);
    ASSERT_EQ(choices.size(), 2u);
    const std::vector<size_t> found = places(gains, choices[1]);
    double most = 0;
    for (size_t a = 0; a < gains.count(); ++a)
      for (size_t b = 0; b < a; ++b) {
        const double gain = gain_of(gains, {a, b});
        most = std::max(most, gain);
        if (a == found[0] || b == found[0] || a == found[1] || b == found[1]) {
          EXPECT_LE(gain, choices[1].gain + 1e-9);
        }
      }
    best += choices[1].gain > most - 1e-9 ? 1 : 0;
  }
  EXPECT_GE(best, 75);
}

TEST(Sizes, StopWhenAnotherSizeDoesNotPay) {
  SizeGains gains = random_gains(1, 3);
  for (std::vector<double>& cell : gains.cells) {
    std::fill(cell.begin(), cell.end(), 0.0);
    cell[3] = 10;
  }
  gains.cells[1][7] = 12;
  EXPECT_EQ(choose_sizes(gains, 15, 3).size(), 1u) << "2 are left to be gained";
  EXPECT_EQ(choose_sizes(gains, 15, 1).size(), 2u);
  const SizeChoice both = choose_sizes(gains, 15, 1).back();
  EXPECT_EQ(both.kinds, (std::vector<int>{1, 2, 1}));
  EXPECT_EQ(both.sizes[1], (WindowSize{7, 6}));
}

}  // namespace
}  // namespace vug::fit
