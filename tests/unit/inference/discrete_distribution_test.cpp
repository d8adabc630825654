// SPDX-License-Identifier: Apache-2.0
// Samples of a discrete distribution match its probabilities in every window.
#include <vug/base/error.h>
#include <vug/inference/choices.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace vug::inference {
namespace {

TEST(DiscreteDistribution, SamplesInAWindowMatchTheProbabilities) {
  const DiscreteDistribution profile({1, 5, 2, 0.5, 4, 1});
  RandomStream stream(RandomKey(1));
  constexpr int kDraws = 200000, kLow = 1, kHigh = 5;
  std::map<int, int> counts;
  for (int i = 0; i < kDraws; ++i) ++counts[profile.find(kLow, kHigh, stream.uniform())];
  double chi_square = 0, all = 0;
  for (int place = kLow; place < kHigh; ++place) {
    const double p = std::exp(profile.ln_probability(kLow, kHigh, place));
    all += p;
    chi_square += std::pow(counts[place] - kDraws * p, 2) / (kDraws * p);
  }
  EXPECT_NEAR(all, 1, 1e-12);
  EXPECT_LT(chi_square, 16.27);  // 3 degrees of freedom, 0.1 %
  EXPECT_EQ(counts.size(), 4u);
  EXPECT_EQ(profile.ln_probability(kLow, kHigh, 5), -std::numeric_limits<double>::infinity());
}

TEST(DiscreteDistribution, EveryIndexOfAMixtureHasAPositiveProbability) {
  const DiscreteDistribution mixed = DiscreteDistribution::mixture({0, 0, 3, 1}, 0.8);
  EXPECT_NEAR(std::exp(mixed.ln_probability(0, 4, 0)), 0.05, 1e-12);
  EXPECT_NEAR(std::exp(mixed.ln_probability(0, 4, 2)), 0.65, 1e-12);
  const DiscreteDistribution even = DiscreteDistribution::mixture({0, 0}, 0.8);
  EXPECT_NEAR(std::exp(even.ln_probability(0, 2, 1)), 0.5, 1e-12);
}

TEST(DiscreteDistribution, InvalidWeightsAreRejected) {
  for (const double weight : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()})
    EXPECT_THROW(DiscreteDistribution({1, weight}), Error) << weight;
}

TEST(Choices, ScoringGivesTheProbabilityOfDrawing) {
  const DiscreteDistribution profile({1, 2, 3, 4});
  RandomStream stream(RandomKey(5));
  Choices drawn, scored, again;
  for (int i = 0; i < 1000; ++i) {
    drawn.draw(stream);
    const int a = drawn.below(7), b = drawn.between(-3, 9), c = drawn.among(profile, 1, 4);
    const bool d = drawn.flip();
    scored.score();
    scored.below(7, a), scored.between(-3, 9, b), scored.among(profile, 1, 4, c), scored.flip(d);
    EXPECT_EQ(drawn.ln_probability(), scored.ln_probability());
    EXPECT_EQ(drawn.trace(), scored.trace());
    again.replay(scored.trace());
    EXPECT_EQ(again.below(7), a);
    EXPECT_EQ(again.between(-3, 9), b);
    EXPECT_EQ(again.among(profile, 1, 4), c);
    EXPECT_EQ(again.flip(), d);
    EXPECT_EQ(again.ln_probability(), scored.ln_probability());
    EXPECT_THROW(again.flip(), Error);
  }
}

TEST(Choices, ImpossibleChoicesHaveProbabilityZero) {
  Choices scored;
  for (const int value : {-1, 3}) {
    scored.score();
    scored.below(3, value);
    EXPECT_FALSE(scored.possible());
    scored.below(3, 1);
    EXPECT_FALSE(scored.possible()) << "remains impossible";
  }
  scored.score();
  scored.below(0, 0);
  EXPECT_FALSE(scored.possible());
}

}  // namespace
}  // namespace vug::inference
