// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/base/parallel.h>

#include <algorithm>

namespace vug::lsystem {
namespace {

/// Derives words by string replacement: the oracle of systems without parameters.
std::string replaced(std::string word, const std::map<char, std::string>& rules, int steps) {
  for (int step = 0; step < steps; ++step) {
    std::string next;
    for (const char letter : word) {
      const auto rule = rules.find(letter);
      next += rule == rules.end() ? std::string(1, letter) : rule->second;
    }
    word = next;
  }
  return word;
}

TEST(Derive, KochIsland) {
  const SystemPtr koch = system_of("axiom F-F-F-F\n F -> F-F+F+FF-F-F+F");
  ASSERT_TRUE(koch);
  EXPECT_EQ(after(*koch, 0), "F-F-F-F");
  EXPECT_EQ(after(*koch, 3), replaced("F-F-F-F", {{'F', "F-F+F+FF-F-F+F"}}, 3));
  // prusinkiewicz1990, figure 1.6
  const std::string island = after(*koch, 5);
  EXPECT_EQ(island.size(), 243419u);
  EXPECT_EQ(std::count(island.begin(), island.end(), 'F'), 131072);
}

TEST(Derive, Hilbert) {
  const SystemPtr hilbert = system_of("axiom L\n L -> +RF-LFL-FR+\n R -> -LF+RFR+FL-");
  ASSERT_TRUE(hilbert);
  const std::string curve = after(*hilbert, 8);
  EXPECT_EQ(std::count(curve.begin(), curve.end(), 'F'), 65535);
  EXPECT_EQ(curve.size(), 218451u);
  EXPECT_EQ(curve, replaced("L", {{'L', "+RF-LFL-FR+"}, {'R', "-LF+RFR+FL-"}}, 8));
}

TEST(Derive, NamesThatBeginWithCapitals) {
  // Gosper's curve, prusinkiewicz1990, figure 1.11.
  const SystemPtr gosper =
      system_of("axiom Fl\n Fl -> Fl+Fr++Fr-Fl--FlFl-Fr+\n Fr -> -Fl+FrFr++Fr+Fl--Fl-Fr");
  ASSERT_TRUE(gosper);
  EXPECT_EQ(after(*gosper, 1), "Fl+Fr++Fr-Fl--FlFl-Fr+");
  EXPECT_EQ(derive(*gosper, {.steps = 4}).word.size(),
            after(*gosper, 4).size() -
                static_cast<size_t>(std::pow(7, 4)));  // each F has a second letter
}

TEST(Derive, ParametersAndGuards) {
  // prusinkiewicz1990, section 1.10.1: the first words of B(2)A(4,4).
  const SystemPtr system = system_of(R"(axiom B(2)A(4,4)
    A(x,y) if y <= 3 -> A(x*2, x+y)
    A(x,y) if y > 3  -> B(x)A(x/y, 0)
    B(x)   if x < 1  -> C
    B(x)   if x >= 1 -> B(x-1))");
  ASSERT_TRUE(system);
  const char* words[] = {"B(2)A(4,4)",  "B(1)B(4)A(1,0)", "B(0)B(3)A(2,1)",
                         "CB(2)A(4,3)", "CB(1)A(8,7)",    "CB(0)B(8)A(1.1428571428571428,0)"};
  for (int step = 0; step < 6; ++step) EXPECT_EQ(after(*system, step), words[step]);
}

TEST(Derive, IsTheSameForAnyNumberOfThreads) {
  const SystemPtr system = system_of(R"(axiom A(1, 0.5)
    A(x, y) @2 -> A(x * 0.9, y..1)[+A(y, x)]
    A(x, y) @1 -> F(x)A(x, pick(y, 1 - y)))");
  ASSERT_TRUE(system);
  std::optional<Derivation> first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const Derivation word = derive(*system, {.steps = 22});
      if (!first) {
        EXPECT_GT(word.word.size(), 50000u);  // several chunks
        first = word;
      }
      EXPECT_TRUE(word == *first) << threads << " threads";
    });
  }
}

TEST(Derive, StopsAtTheModuleLimit) {
  const SystemPtr bomb = system_of("axiom A\n limit 5000\n A -> B A A\n B -> B");
  ASSERT_TRUE(bomb);
  EXPECT_EQ(derive(*bomb, {.steps = 11}).word.size(), 4095u);
  try {
    derive(*bomb, {.steps = 12});
    FAIL() << "no limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_STREQ(error.what(),
                 "grammar 'g' exceeds its limit of 5000 modules: the next step makes 8191, 6144 of "
                 "them by the rule of 'A'");
    EXPECT_EQ(error.where().line, 4);
  }
}

TEST(Derive, StopsAtTheMemoryLimit) {
  const SystemPtr bomb =
      system_of("axiom A(1)\n A(x) -> B A(x)A(x)\n B -> C(1, 2, 3, 4, 5, 6, 7, 8)");
  ASSERT_TRUE(bomb);
  EXPECT_EQ(derive(*bomb, {.steps = 9, .memory = 100000}).word.size(), 1023u);
  try {
    derive(*bomb, {.steps = 20, .memory = 100000});
    FAIL() << "no bound";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_STREQ(error.what(),
                 "grammar 'g' exceeds the memory of 97.7 KiB: the next step makes 4095 modules in "
                 "112 KiB, 4096 of their parameters by the rule of 'B'");
    EXPECT_EQ(error.where().line, 4);
  }
}

TEST(Derive, RejectsNonFiniteNumbers) {
  const SystemPtr system = system_of("axiom A(1)\n A(x) -> B(2)A(x / (x - 1))");
  ASSERT_TRUE(system);
  try {
    after(*system, 1);
    FAIL() << "infinite";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_STREQ(error.what(), "parameter 1 of module 2 of the rule of 'A(x)' is inf");
    EXPECT_EQ(error.where().line, 3);
  }
}

}  // namespace
}  // namespace vug::lsystem
