// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/base/rng.h>
#include <vug/lsystem/random_numbers.h>

#include <algorithm>
#include <array>
#include <sstream>

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

TEST(Chance, WeightsAreRelative) {
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

TEST(Chance, DrawsAreUniform) {
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

TEST(Chance, GuardsHaveTheirOwnRandomNumbers) {
  // The second rule does not use the random number that the first one rejected.
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
  RandomNumbers draws(key, 2);
  const std::array<uint64_t, 3> modules{0, 0xfedcba9876543210, ~uint64_t{0}};
  for (const uint64_t module : modules) draws.request(module, 3);
  const double* numbers = draws.generate();
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
  // A waiting module has the same probability in every step.
  const Word word = choices("A if (0..1) < 0.5 -> B", 20);
  size_t waiting = 0;
  for (size_t i = 0; i < word.size(); ++i) waiting += word.symbol(i) != word.symbol(0) ? 1 : 0;
  const double share = static_cast<double>(waiting) / static_cast<double>(word.size());
  // Two steps have passed for the first ones; none waits with certainty.
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.8);
}

TEST(Chance, ABranchKeepsItsNumbers) {
  // The random numbers of a branch do not depend on its neighbours.
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

TEST(Chance, ZeroWeightsKeepTheModule) {
  const SystemPtr system = system_of("axiom A(0)A(1)\n A(x) @x -> B");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "A(0)B");
}

TEST(Chance, ZeroWeightsPassToOtherRules) {
  const SystemPtr constant = system_of("axiom A\n A @0 -> X\n A -> Y");
  const SystemPtr computed = system_of("axiom A(0)A(1)\n A(x) @x -> X\n A(x) -> Y");
  const SystemPtr between = system_of("axiom A\n A @0 -> X\n A -> Y\n A @1 -> Z");
  ASSERT_TRUE(between);
  EXPECT_EQ(after(*between, 1), "Y");
  const SystemPtr leading = system_of("axiom A\n A @0 -> X\n A @0 -> Y\n A @1 -> Z\n A -> W");
  ASSERT_TRUE(leading);
  EXPECT_EQ(after(*leading, 1), "Z");
  const SystemPtr context = system_of("axiom BA(0)BA(1)\n B < A(x) @x -> X\n A(x) -> Y");
  ASSERT_TRUE(constant && computed && context);
  EXPECT_EQ(after(*constant, 1), "Y");
  EXPECT_EQ(after(*computed, 1), "YX");
  EXPECT_EQ(after(*context, 1), "BYBX");
}

std::string fault(const System& system) {
  try {
    after(system, 1);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    return error.what() + ("; " + error.hint());
  }
}

TEST(Chance, BadWeights) {
  const SystemPtr below = system_of("axiom A(1)\n A(x) @(x - 2) -> B");
  const SystemPtr beyond = system_of("axiom A\n A @1e308 -> B\n A @1e308 -> C");
  ASSERT_TRUE(below && beyond);
  EXPECT_EQ(fault(*below),
            "the weight of the rule of 'A(x)' is -1; weights must be 0 or more; only their ratios "
            "matter");
  EXPECT_EQ(
      fault(*beyond),
      "the sum of the weights up to that of the rule of 'A' is inf; weights must be 0 or more; "
      "only their ratios matter");
  const Compiled constant = compile_text("grammar g: lsystem {\n axiom A\n A @-2 -> B\n}\n");
  EXPECT_FALSE(constant.system);
  EXPECT_NE(constant.report.find("test.vug:3:5: error: invalid weight -2"), std::string::npos)
      << constant.report;
}

TEST(Chance, ComparisonsRejectNonFiniteNumbers) {
  for (const char* rule :
       {"A(x) if 1 / x > 3 -> B", "A(x) if not (x / x < 3) -> B", "A(x) -> B(if(1 / x > 2, 1, 0))",
        "A(x) if x < 0 or log(x) < 1 -> B", "A(x) @if(1 / x == 1, 1, 2) -> B"}) {
    const SystemPtr system = system_of(std::string("axiom A(0)\n ") + rule);
    ASSERT_TRUE(system);
    EXPECT_EQ(fault(*system).find("one side of a comparison of the rule of 'A(x)' is "), 0u)
        << rule;
  }
  const SystemPtr careful = system_of("axiom A(0)A(1)\n A(x) if x != 0 and 1 / x > 0.5 -> B");
  ASSERT_TRUE(careful);
  EXPECT_EQ(after(*careful, 1), "A(0)B");
}

/// The rules with warnings, identified by their successors.
std::string unreached(const std::string& rules, const std::string& axiom = "A") {
  const std::string text = "grammar g: lsystem {\n axiom " + axiom + "\n" + rules + "\n}\n";
  const Compiled compiled = compile_text(text);
  EXPECT_TRUE(compiled.system) << compiled.report;
  std::string out;
  for (const Diagnostic& each : compiled.diagnostics.all()) {
    EXPECT_NE(each.message.find("is never applied"), std::string::npos);
    std::istringstream lines(text);
    std::string line;
    for (int i = 0; i < each.where.line; ++i) std::getline(lines, line);
    out += line.back();
  }
  return out;
}

TEST(Chance, UnreachableRulesAreReported) {
  EXPECT_EQ(unreached("A -> B\nA -> C"), "C");
  EXPECT_EQ(unreached("A -> B\nA @1 -> C"), "C");
  EXPECT_EQ(unreached("A @1 -> B\nA -> C\nA @1 -> D"), "C");  // D can be selected in addition to B
  EXPECT_EQ(unreached("A @0 -> B\nA -> C\nA @1 -> D"), "D");
  EXPECT_EQ(unreached("A @1 if pick(0, 1) > 0 -> B\nA -> C\nA @1 -> D"), "");
  EXPECT_EQ(unreached("A if 1 > 2 -> B\nA -> C"), "");
  EXPECT_EQ(unreached("A if 1 < 2 -> B\nA -> C"), "C");
  EXPECT_EQ(unreached("B < A -> B\nA -> C\nA -> D"), "D");
  EXPECT_EQ(unreached("A(t) after 2 -> B\nA(t) after 1 -> C\nA(t) after 3 -> D", "A(0)"), "D");
}

}  // namespace
}  // namespace vug::lsystem
