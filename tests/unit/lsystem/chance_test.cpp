#include "samples.h"

#include <vug/base/rng.h>
#include <vug/lsystem/draws.h>

#include <algorithm>
#include <array>

namespace vug::lsystem {
namespace {

/// 100,000 modules, each rewritten once.
std::string many(const std::string& rules) {
  return "axiom S(100000)\n S(n) if n > 1 -> S(floor(n / 2))S(n - floor(n / 2))\n"
         " S(n) if n <= 1 -> A\n" +
         rules;
}

Word choices(const std::string& rules, int steps = 19) {
  const SystemPtr system = system_of(many(rules));
  EXPECT_TRUE(system);
  DeriveOptions options;
  options.steps = steps;
  return derive(*system, options).word;
}

TEST(Chance, WeightsAreShares) {
  const SystemPtr system =
      system_of(many("A @1 -> X\n A @2 -> Y\n A @3 -> Z\n A @0.5 if 1 > 2 -> W"));
  DeriveOptions options;
  options.steps = 19;
  const Word word = derive(*system, options).word;
  ASSERT_EQ(word.size(), 100000u);
  std::map<std::string, double> seen;
  for (const SymbolId symbol : word.symbols()) ++seen[system->alphabet.name(symbol)];
  EXPECT_EQ(seen.count("W") + seen.count("A"), 0u);
  double chi = 0;
  const std::array<std::pair<const char*, double>, 3> shares{{{"X", 1}, {"Y", 2}, {"Z", 3}}};
  for (const auto& [name, share] : shares) {
    const double expected = 1e5 * share / 6;
    chi += (seen[name] - expected) * (seen[name] - expected) / expected;
  }
  EXPECT_LT(chi, 13.8);  // two degrees of freedom, 0.1 %
}

TEST(Chance, DrawsAreEven) {
  const Word word = choices("A -> B(0..1, pick(1, 2, 3, 4))");
  ASSERT_EQ(word.size(), 100000u);
  std::array<double, 16> bins{};
  std::array<double, 4> picks{};
  double product = 0, sum = 0;
  for (size_t i = 0; i < word.size(); ++i) {
    const double x = word.parameters(i)[0];
    ASSERT_TRUE(x >= 0 && x < 1);
    ++bins.at(static_cast<size_t>(x * 16));
    ++picks.at(static_cast<size_t>(word.parameters(i)[1]) - 1);
    sum += x;
    if (i > 0) product += (x - 0.5) * (word.parameters(i - 1)[0] - 0.5);
  }
  double chi = 0, chi_picks = 0;
  for (const double n : bins) chi += (n - 6250) * (n - 6250) / 6250;
  for (const double n : picks) chi_picks += (n - 25000) * (n - 25000) / 25000;
  EXPECT_LT(chi, 37.7);  // 15 degrees of freedom, 0.1 %
  EXPECT_LT(chi_picks, 16.3);
  EXPECT_NEAR(sum / 1e5, 0.5, 0.003);
  EXPECT_NEAR(product / 1e5, 0, 4 / 12.0 / std::sqrt(1e5));  // neighbours are independent
}

TEST(Chance, GuardsDrawOnTheirOwn) {
  // The second rule does not look at the number that the first one has refused.
  const Word word = choices(
      "A if (0..1) < 0.2 -> B(0, 0..1)\n A if (0..1) < 0.5 -> B(1, 0..1)\n"
      " A -> B(2, 0..1)");
  std::array<double, 3> seen{};
  double sum = 0;
  for (size_t i = 0; i < word.size(); ++i) {
    ++seen.at(static_cast<size_t>(word.parameters(i)[0]));
    sum += word.parameters(i)[1];
  }
  double chi = 0;
  const std::array<double, 3> expected{20000, 40000, 40000};
  for (size_t k = 0; k < 3; ++k)
    chi += (seen.at(k) - expected.at(k)) * (seen.at(k) - expected.at(k)) / expected.at(k);
  EXPECT_LT(chi, 13.8);  // two degrees of freedom, 0.1 %
  EXPECT_NEAR(sum / 1e5, 0.5, 0.003);
}

TEST(Chance, ChoicesAndDrawsAreIndependent) {
  const Word word = choices("A @1 -> B(0, 0..1, 0..1, 0..1)\n A @1 -> B(1, 0..1, 0..1, 0..1)");
  ASSERT_EQ(word.size(), 100000u);
  std::array<double, 16> cells{};  // each of the four numbers in its lower or upper half
  for (size_t i = 0; i < word.size(); ++i) {
    size_t cell = 0;
    for (const double value : word.parameters(i)) cell = 2 * cell + (value < 0.5 ? 0 : 1);
    ++cells.at(cell);
  }
  double chi = 0;
  for (const double n : cells) chi += (n - 6250) * (n - 6250) / 6250;
  EXPECT_LT(chi, 37.7);  // 15 degrees of freedom, 0.1 %
}

TEST(Chance, KeysDiffer) {
  const SystemPtr system = system_of("axiom A\n A @1 -> F[+A][-A]A");
  ASSERT_TRUE(system);
  Derivation word = derive(*system, {.steps = 11});
  ASSERT_GT(word.keys.size(), 600000u);
  std::sort(word.keys.begin(), word.keys.end());
  EXPECT_TRUE(std::adjacent_find(word.keys.begin(), word.keys.end()) == word.keys.end());
}

TEST(Chance, NumbersAreThoseOfPhilox) {
  const uint64_t key = 0x0123456789abcdef;
  Draws draws(key, 2);
  const std::array<uint64_t, 3> modules{0, 0xfedcba9876543210, ~uint64_t{0}};
  for (const uint64_t module : modules) draws.ask(module, 3);
  const double* numbers = draws.make();
  for (const uint64_t module : modules)
    for (uint32_t block = 0; block < 3; ++block) {
      const auto bits =
          philox4x32({static_cast<uint32_t>(module), static_cast<uint32_t>(module >> 32), block, 2},
                     {static_cast<uint32_t>(key), static_cast<uint32_t>(key >> 32)});
      for (size_t half = 0; half < 2; ++half) {
        const uint64_t wide = uint64_t{bits.at(2 * half)} << 32 | bits.at(2 * half + 1);
        EXPECT_EQ(*numbers++, static_cast<double>(wide >> 12) * 0x1p-52);
      }
    }
}

TEST(Chance, EachStepDrawsAgain) {
  // A module that waits for its luck has the same chance in every step.
  const Word word = choices("A if (0..1) < 0.5 -> B", 20);
  size_t waiting = 0;
  for (size_t i = 0; i < word.size(); ++i) waiting += word.symbol(i) != word.symbol(0) ? 1 : 0;
  const double share = static_cast<double>(waiting) / static_cast<double>(word.size());
  // Two steps have passed for those that were ready first; nobody waits with certainty.
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.8);
}

TEST(Chance, ABranchKeepsItsNumbers) {
  // What stands beside a branch does not change what it draws.
  const SystemPtr one = system_of("axiom [A]\n A -> F(0..1)[+A]A");
  const SystemPtr two = system_of("axiom [A][A]\n A -> F(0..1)[+A]A");
  ASSERT_TRUE(one && two);
  const std::string alone = after(*one, 6), both = after(*two, 6);
  EXPECT_EQ(both.substr(0, alone.size()), alone);
  EXPECT_NE(both.substr(alone.size()), alone);
}

TEST(Chance, SeedsDiffer) {
  const std::string rules = "axiom A\n A -> F(0..1)A\n";
  const SystemPtr first = system_of(rules), second = system_of(rules + " seed 8");
  ASSERT_TRUE(first && second);
  EXPECT_NE(after(*first, 3), after(*second, 3));
}

TEST(Chance, WeightsOfZeroLeaveTheModule) {
  const SystemPtr system = system_of("axiom A(0)A(1)\n A(x) @x -> B");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "A(0)B");
}

TEST(Chance, BadWeights) {
  const SystemPtr system = system_of("axiom A(1)\n A(x) @(x - 2) -> B");
  ASSERT_TRUE(system);
  EXPECT_THROW(after(*system, 1), Error);
}

}  // namespace
}  // namespace vug::lsystem
