// SPDX-License-Identifier: Apache-2.0
// A chain over lists of numbers of variable length with known probabilities.
#include <vug/base/error.h>
#include <vug/inference/tempering.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace vug::inference {
namespace {

constexpr int kLongest = 3, kDigits = 4;
using Digits = std::vector<int>;

/// Energy in bits with two modes that are far apart for single steps.
double energy(const Digits& digits) {
  double bits = 1.5 * static_cast<double>(digits.size());
  for (const int digit : digits) bits += digit == 0 ? 0 : digit == 3 ? 0.5 : 3;
  return bits;
}

bool in_order(const Digits& digits) {
  for (size_t i = 1; i < digits.size(); ++i)
    if (digits[i - 1] > digits[i]) return false;
  return true;
}

/// Inserts or removes a digit. States are sorted, so positions need not be chosen.
bool birth_or_death(Digits& digits, Choices& forward, Choices& back) {
  const bool birth = forward.flip();
  back.flip(!birth);
  const auto count = static_cast<int>(digits.size());
  if (birth) {
    const int digit = forward.below(kDigits);
    const auto at = std::upper_bound(digits.begin(), digits.end(), digit);
    back.below(count + 1, static_cast<int>(at - digits.begin()));
    digits.insert(at, digit);
    return count < kLongest;
  }
  if (count == 0) return false;
  const int which = forward.below(count);
  const int digit = digits[static_cast<size_t>(which)];
  // The reverse move inserts it after equal digits.
  if (static_cast<size_t>(which) + 1 < digits.size() &&
      digits[static_cast<size_t>(which) + 1] == digit)
    return false;
  digits.erase(digits.begin() + which);
  back.below(kDigits, digit);
  return true;
}

bool change(Digits& digits, Choices& forward, Choices& back) {
  if (digits.empty()) return false;
  const auto count = static_cast<int>(digits.size());
  int& digit = digits[static_cast<size_t>(forward.below(count))];
  back.below(count, static_cast<int>(&digit - digits.data()));
  back.below(kDigits, digit);
  digit = forward.below(kDigits);
  return in_order(digits);
}

const Moves<Digits>& moves() {
  static const Moves<Digits> all = {{"birth or death", 2, birth_or_death}, {"change", 1, change}};
  return all;
}

std::map<Digits, double> exact() {
  std::map<Digits, double> out;
  double sum = 0;
  const std::function<void(const Digits&)> add = [&](const Digits& digits) {
    sum += out[digits] = std::exp2(-energy(digits));
    if (static_cast<int>(digits.size()) == kLongest) return;
    for (int next = digits.empty() ? 0 : digits.back(); next < kDigits; ++next) {
      Digits longer = digits;
      longer.push_back(next);
      add(longer);
    }
  };
  add({});
  for (auto& [digits, p] : out) p /= sum;
  return out;
}

double total_variation(const std::map<Digits, double>& counts, double all) {
  double sum = 0;
  for (const auto& [digits, p] : exact()) {
    const auto found = counts.find(digits);
    sum += std::fabs((found == counts.end() ? 0 : found->second / all) - p);
  }
  return sum / 2;
}

double after(int64_t steps, Chain<Digits>::Options options) {
  Chain<Digits> chain(moves(), energy, {}, RandomKey(7), options);
  std::map<Digits, double> counts;
  for (int64_t i = 0; i < steps; ++i) {
    chain.step();
    ++counts[chain.state()];
  }
  return total_variation(counts, static_cast<double>(steps));
}

TEST(Chain, SamplesTheStationaryDistribution) {
  EXPECT_EQ(exact().size(), 35u);
  EXPECT_LT(after(1'000'000, {}), 0.006);
}

TEST(Chain, IsBiasedWithoutTheProposalRatio) {
  EXPECT_GT(after(1'000'000, {.use_proposal_ratio = false}), 0.05);
}

TEST(Chain, EveryMoveIsReversible) {
  Chain<Digits> chain(moves(), energy, {}, RandomKey(11));
  RandomStream stream(RandomKey(3));
  Choices forward, back, again, returned;
  int done = 0;
  for (int i = 0; i < 20000; ++i) {
    chain.step();
    for (const Move<Digits>& move : moves()) {
      Digits digits = chain.state();
      forward.draw(stream);
      back.score();
      if (!move.propose(digits, forward, back)) continue;
      ++done;
      again.replay(back.trace());
      returned.score();
      ASSERT_TRUE(move.propose(digits, again, returned));
      EXPECT_EQ(digits, chain.state());
      EXPECT_NEAR(again.ln_probability(), back.ln_probability(), 1e-12);
      EXPECT_NEAR(returned.ln_probability(), forward.ln_probability(), 1e-12);
    }
  }
  EXPECT_GT(done, 10000);
}

TEST(Tempering, TheColdestChainSamplesTheStationaryDistribution) {
  TemperingOptions options;
  options.chains = 4;
  options.hottest = 8;
  options.per_round = 5;
  Tempering<Digits> chains(
      moves(), [] { return energy; }, {Digits{}}, RandomKey(2), options);
  std::map<Digits, double> counts;
  chains.run(100'000, false, Progress::none(), [&](const Digits& state, double bits) {
    ++counts[state];
    EXPECT_EQ(bits, energy(state));
  });
  EXPECT_LT(total_variation(counts, 100'000), 0.01);
  EXPECT_EQ(chains.best_energy(), 0);
}

/// No move leads from one state to another, so only a hotter chain can bring the better one.
TEST(Tempering, ABetterStartOfAHotterChainMovesDownTheLadder) {
  const Moves<Digits> none = {{"none", 1, [](Digits&, Choices&, Choices&) { return false; }}};
  TemperingOptions options;
  options.chains = 4;
  const Digits worse(1, 9), better(1, 0);
  Tempering<Digits> chains(
      none, [] { return [](const Digits& at) { return 5.0 * at[0]; }; }, {worse, worse, better},
      RandomKey(5), options);
  EXPECT_EQ(chains.best_energy(), 0);
  EXPECT_EQ(chains.chains()[0].energy(), 45);
  chains.run(20, false);
  EXPECT_EQ(chains.chains()[0].energy(), 0);
}

TEST(Tempering, IsDeterministicForAnyNumberOfThreads) {
  std::vector<Digits> seen[4];
  int run = 0;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      Tempering<Digits> chains(moves(), [] { return energy; }, {Digits{}}, RandomKey(2), {});
      chains.run(20, true, Progress::none(),
                 [&](const Digits& state, double) { seen[run].push_back(state); });
      ++run;
    });
  }
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(seen[0], seen[2]);
  EXPECT_EQ(seen[0], seen[3]);
}

/// A box of whole numbers with a parabola in each direction: the energy distribution of a gas.
TEST(Tempering, TemperaturesAdaptToEqualAcceptance) {
  constexpr int kSide = 200;
  const auto bowl = [](const Digits& at) {
    double bits = 0;
    for (const int x : at) bits += 0.02 * x * x;
    return bits;
  };
  const Moves<Digits> walk = {{"walk", 1, [](Digits& at, Choices& forward, Choices& back) {
                                 const int which = forward.below(static_cast<int>(at.size()));
                                 int& x = at[static_cast<size_t>(which)];
                                 const int step = forward.between(-20, 20);
                                 x += step;
                                 back.below(static_cast<int>(at.size()), which);
                                 back.between(-20, 20, -step);
                                 return std::abs(x) <= kSide;
                               }}};
  TemperingOptions options;
  options.chains = 6;
  options.hottest = 1000;
  options.per_round = 50;
  Tempering<Digits> chains(
      walk, [&] { return bowl; }, {Digits(8, 0)}, RandomKey(4), options);
  chains.run(2000, true);
  chains.forget_swaps();
  chains.run(1000, false);
  for (const TemperatureLadder::Swaps& swaps : chains.ladder().swaps()) {
    EXPECT_GT(swaps.rate(), 0.2);
    EXPECT_LT(swaps.rate(), 0.6);
  }
  EXPECT_EQ(chains.chains()[0].temperature(), 1);
}

TEST(Tempering, TemperaturesMustIncrease) {
  EXPECT_THROW(TemperatureLadder(0, 1, 2), Error);
  EXPECT_THROW(TemperatureLadder(2, 0, 2), Error);
  EXPECT_THROW(TemperatureLadder(2, 2, 2), Error);
}

}  // namespace
}  // namespace vug::inference
