// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <cmath>

namespace vug::lsystem {
namespace {

std::string at(const System& system, double time) {
  DeriveOptions options;
  options.time = time;
  return to_string(derive(system, options).word, system.alphabet);
}

// prusinkiewicz1990, section 6.1: Anabaena with ages.
const char* const kAnabaena = R"(axiom Ar(0)
    Ar(t) after 1 -> Al(0)Br(0)
    Al(t) after 1 -> Bl(0)Ar(0)
    Br(t) after 1 -> Ar(0)
    Bl(t) after 1 -> Al(0))";

TEST(Growth, TimedAnabaena) {
  const SystemPtr timed = system_of(kAnabaena);
  ASSERT_TRUE(timed);
  EXPECT_EQ(at(*timed, 0), "Ar(0)");
  EXPECT_EQ(at(*timed, 0.75), "Ar(0.75)");
  EXPECT_EQ(at(*timed, 1), "Al(0)Br(0)");
  EXPECT_EQ(at(*timed, 2.25), "Bl(0.25)Ar(0.25)Ar(0.25)");
  // At whole times it equals the system without ages, section 1.2.
  const SystemPtr plain = system_of("axiom Ar\n Ar -> AlBr\n Al -> BlAr\n Br -> Ar\n Bl -> Al");
  for (int step = 0; step < 8; ++step) {
    std::string word = at(*timed, step), bare;
    for (size_t i = 0; i < word.size(); ++i)
      if (word[i] == '(')
        i = word.find(')', i);
      else
        bare += word[i];
    EXPECT_EQ(bare, after(*plain, step));
  }
}

TEST(Growth, LengthsMoveContinuously) {
  // A cell's length is 2^age, and it divides into two halves at age 1: the filament grows by 2^t.
  const SystemPtr system =
      system_of("axiom C(0)\n C(t) after 1 -> C(0)C(0)\n interpret { C(t) -> F(2 ^ t) }");
  ASSERT_TRUE(system);
  double before = 1;
  for (double time = 0; time < 5; time += 1.0 / 64) {
    DeriveOptions options;
    options.time = time;
    const Word word = interpret(*system, derive(*system, options));
    double length = 0;
    for (const double x : word.values()) length += x;
    EXPECT_NEAR(length, std::pow(2, time), 1e-9 * length) << time;
    EXPECT_LE(length / before, std::pow(2, 1.0 / 64) + 1e-9);
    before = length;
  }
}

TEST(Growth, InitialAndIndividualTerminalAges) {
  const SystemPtr system = system_of(
      "axiom A(0.5, 2)\n ages L\n A(t, n) after n -> L(0)B(-1)A(0.25, n)\n B(t) after 0 -> L(0)");
  ASSERT_TRUE(system);
  EXPECT_EQ(at(*system, 1), "A(1.5,2)");
  EXPECT_EQ(at(*system, 2), "L(0.5)B(-0.5)A(0.75,2)");
  EXPECT_EQ(at(*system, 3), "L(1.5)L(0.5)A(1.75,2)");
}

TEST(Growth, RandomChoicesDoNotChangeOverTime) {
  const SystemPtr system = system_of("axiom A(0)\n A(t) after (0.5..1) -> F(0..1)[+A(0)]A(0)");
  ASSERT_TRUE(system);
  // The random choices made by time 4 are unchanged at time 6, in the same order.
  const auto drawn_by = [&](double time) {
    DeriveOptions options;
    options.time = time;
    const Word word = derive(*system, options).word;
    std::vector<double> out;
    for (size_t i = 0; i < word.size(); ++i)
      if (system->alphabet.name(word.symbol(i)) == "F") out.push_back(word.parameters(i)[0]);
    return out;
  };
  const std::vector<double> early = drawn_by(4), late = drawn_by(6);
  ASSERT_GT(early.size(), 10u);
  size_t found = 0;
  for (const double value : late)
    if (found < early.size() && value == early[found]) ++found;
  EXPECT_EQ(found, early.size());
}

TEST(Growth, NonterminatingGrowthIsStopped) {
  const SystemPtr system = system_of("axiom A(0)\n A(t) after 1 -> A(1)");
  ASSERT_TRUE(system);
  EXPECT_THROW(at(*system, 2), Error);
}

}  // namespace
}  // namespace vug::lsystem
