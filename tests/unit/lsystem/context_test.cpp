// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <algorithm>
#include <tuple>

namespace vug::lsystem {
namespace {

TEST(Context, SignalRunsThroughAWord) {
  // prusinkiewicz1990, section 1.8: b moves from the left to the right.
  const SystemPtr system = system_of("axiom BAAAAAAA\n B < A -> B\n B -> A");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "ABAAAAAA");
  EXPECT_EQ(after(*system, 3), "AAABAAAA");
  EXPECT_EQ(after(*system, 8), "AAAAAAAA");
}

TEST(Context, BranchesOfThePublication) {
  // prusinkiewicz1990, section 1.8: BC < S > G[H]M fits S in ABC[DE][SG[HI[JK]L]MNO].
  const SystemPtr system = system_of("axiom ABC[DE][SG[HI[JK]L]MNO]\n BC < S > G[H]M -> X");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "ABC[DE][XG[HI[JK]L]MNO]");
}

struct Case {
  const char* rule;
  const char* axiom;
  const char* expected;
};

class ContextCases : public ::testing::TestWithParam<Case> {};

TEST_P(ContextCases, Fits) {
  const Case& c = GetParam();
  const SystemPtr system = system_of(std::string("axiom ") + c.axiom + "\n" + c.rule);
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), c.expected) << c.rule;
}

INSTANTIATE_TEST_SUITE_P(
    Branches, ContextCases,
    ::testing::Values(
        // The left context follows the path to the root and skips side branches.
        Case{"A < B -> X", "A[C]B", "A[C]X"}, Case{"A < B -> X", "A[C[D]][E]B", "A[C[D]][E]X"},
        Case{"A < B -> X", "A[B]C", "A[X]C"}, Case{"A < B -> X", "A[[B]]C", "A[[X]]C"},
        Case{"C < B -> X", "A[C]B", "A[C]B"}, Case{"AC < B -> X", "A[D]C[B]", "A[D]C[X]"},
        Case{"A < B -> X", "B", "B"}, Case{"A < B -> X", "[A]B", "[A]B"},
        // The right context follows the same branch and skips side branches unless it enters one.
        Case{"A > B -> X", "A[C]B", "X[C]B"}, Case{"A > B -> X", "A[B]C", "A[B]C"},
        Case{"A > B -> X", "[A]B", "[A]B"}, Case{"A > [B] -> X", "A[B]C", "X[B]C"},
        Case{"A > [B]C -> X", "A[D][BE]C", "X[D][BE]C"},
        Case{"A > [B][C] -> X", "A[B][C]", "X[B][C]"},
        Case{"A > [B][C] -> X", "A[C][B]", "A[C][B]"},
        Case{"A > [B[C]D] -> X", "A[B[E][CF]D]", "X[B[E][CF]D]"}, Case{"A > BC -> X", "AB", "AB"},
        // Ignored modules are skipped; with 'consider', all others are skipped.
        Case{"ignore + - F\n A < B > C -> X", "A+FB-[D]FC", "A+FX-[D]FC"},
        Case{"consider A B\n A < B -> X", "ACDB", "ACDX"},
        // Rules with a context precede those without.
        Case{"B -> Y\n A < B -> X", "ABB", "AXY"}));

TEST(Context, ParametersOfNeighbours) {
  const SystemPtr system = system_of(
      "axiom A(1)A(2)[B(7)]A(4)\n A(l) < A(x) > [B(b)]A(r) if l < r -> A(l + 10*x + 100*r + "
      "1000*b)");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "A(1)A(7421)[B(7)]A(4)");
}

TEST(Context, SkipsManyModulesOfManyBranches) {
  // Each of them skips all ignored modules: without precomputed neighbours this takes minutes.
  constexpr int kMany = 150000;
  std::string far = "A", branches = "A";
  for (int i = 0; i < kMany; ++i) far += "F", branches += "[B]";
  for (const auto& [axiom, rules, change] :
       {std::tuple(far, "ignore F\n A < F > C -> X", "FX"),
        std::tuple(branches, "A < B > C -> X\n A > C -> X", "BX")}) {
    const SystemPtr system = system_of("axiom " + axiom + "\n" + rules);
    const SystemPtr ended = system_of("axiom " + axiom + "C\n" + rules);
    ASSERT_TRUE(system && ended);
    EXPECT_EQ(after(*system, 1), axiom);
    std::string replaced = axiom + "C";
    if (change[0] == 'F')
      std::replace(replaced.begin(), replaced.end(), 'F', 'X');
    else
      replaced[0] = 'X';
    EXPECT_EQ(after(*ended, 1), replaced);
  }
}

TEST(Context, HogewegAndHesper) {
  // prusinkiewicz1990, figure 1.31 a, with O and I for 0 and 1.
  const SystemPtr system = system_of(R"(axiom FIFIFI
    ignore + - F
    O < O > O -> O
    O < O > I -> I[+FIFI]
    O < I > O -> I
    O < I > I -> I
    I < O > O -> O
    I < O > I -> IFI
    I < I > O -> O
    I < I > I -> O
    + -> -
    - -> +)");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "FIFOFI");
  EXPECT_EQ(after(*system, 2), "FIFIFIFI");
  EXPECT_EQ(after(*system, 4), "FIFOFI[+FIFI]FI");
  EXPECT_EQ(after(*system, 7), "FIFOFOFI[+FIFI][-FIFOFI]FI");
}

}  // namespace
}  // namespace vug::lsystem
