// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/base/parallel.h>

namespace vug::lsystem {
namespace {

TEST(Cut, RemovesTheRestOfTheBranch) {
  // The cut takes effect in the next rewriting step (prusinkiewicz1990, section 3.1).
  const SystemPtr system = system_of("axiom A[BC%D[E]F]G\n C -> X%Y\n G -> H%I");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "A[BX%Y]H%I");
  EXPECT_EQ(after(*system, 2), "A[BX]H");
}

TEST(Cut, BranchesAreShed) {
  // prusinkiewicz1990, section 3.1, with short-lived branches.
  const SystemPtr system = system_of(R"(axiom A
    A -> F(1)[-X(1)B][+X(1)B]A
    B -> F(1)B
    X(d) if d > 0  -> X(d-1)
    X(d) if d == 0 -> U%
    U -> F(0.3))");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 2), "F(1)[-X(0)F(1)B][+X(0)F(1)B]F(1)[-X(1)B][+X(1)B]A");
  EXPECT_EQ(after(*system, 3).substr(0, 36), "F(1)[-U%F(1)F(1)B][+U%F(1)F(1)B]F(1)");
  EXPECT_EQ(after(*system, 4).substr(0, 30), "F(1)[-F(0.3)][+F(0.3)]F(1)[-U%");
}

TEST(Stages, DecompositionIsPartOfEachStep) {
  const SystemPtr system = system_of(R"(axiom S(2)
    S(n) -> S(n + 1)
    decompose { S(n) if n > 3 -> A S(n - 3) })");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 1), "S(3)");
  EXPECT_EQ(after(*system, 2), "AS(1)");
  EXPECT_EQ(after(*system, 5), "AAS(1)");
}

TEST(Stages, InterpretationDoesNotFeedBack) {
  const SystemPtr system = system_of(R"(axiom A
    A -> B A
    interpret {
      B -> [+C]
      C -> F F
    })");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 2), "BBA");
  EXPECT_EQ(drawn(*system, 2), "[+FF][+FF]A");
}

TEST(Stages, DepthLimitsTheRounds) {
  const SystemPtr system = system_of("axiom F\n interpret { depth 3\n F -> F+F }");
  ASSERT_TRUE(system);
  EXPECT_EQ(drawn(*system, 0), "F+F+F+F+F+F+F+F");
}

TEST(Stages, LeftRecursionIsRejected) {
  for (const char* rules :
       {"F -> F+F", "A -> B\n B -> +A", "A @1 -> A F\n A @2 -> A", "A(x) -> A(x-1)"}) {
    const Compiled compiled = compile_text(std::string("grammar g: lsystem {\n axiom F\n"
                                                       " interpret {\n") +
                                           rules + "\n}\n}\n");
    EXPECT_FALSE(compiled.system);
    EXPECT_NE(compiled.report.find("never terminates: "), std::string::npos) << compiled.report;
    EXPECT_NE(compiled.report.find("test.vug:4:"), std::string::npos) << compiled.report;
  }
  // A recursion ended by a guard is accepted; a failing guard is detected at run time.
  EXPECT_EQ(drawn(*system_of("axiom A(3)\n interpret { A(x) if x > 0 -> F A(x-1) }"), 0),
            "FFFA(0)");
  const SystemPtr endless =
      system_of("axiom A(3)\n limit 99999\n interpret { A(x) if x > 0 -> F A(x+1) }");
  ASSERT_TRUE(endless);
  EXPECT_THROW(drawn(*endless, 0), Error);
}

TEST(Tables, FollowTheSchedule) {
  const SystemPtr system = system_of(R"(axiom A B
    schedule spring*2 summer
    B -> B C
    table spring { A -> X A }
    table summer { A -> Y A })");
  ASSERT_TRUE(system);
  EXPECT_EQ(after(*system, 3), "XXYABCCC");
  EXPECT_EQ(after(*system, 6), "XXYXXYABCCCCCC");
}

TEST(SubSystems, AModuleIsReplacedByAWord) {
  const Compiled compiled = compile_text(R"(
    grammar Leaf: lsystem { axiom L
      steps 1
      L -> F[+L][-L] }
    grammar plant: lsystem { axiom A
      A -> F Leaf(2) A
      interpret { A -> Leaf } })");
  ASSERT_TRUE(compiled.system) << compiled.report;
  EXPECT_EQ(after(*compiled.system, 1), "FLeaf(2)A");
  EXPECT_EQ(drawn(*compiled.system, 1), "FF[+F[+L][-L]][-F[+L][-L]]F[+L][-L]");
}

TEST(SubSystems, TurtleCommandsAreNotReplaced) {
  const Compiled compiled =
      compile_text("grammar F: lsystem { axiom A }\ngrammar plant: lsystem { axiom F F }");
  ASSERT_TRUE(compiled.system) << compiled.report;
  EXPECT_EQ(drawn(*compiled.system, 0), "FF");
}

TEST(SubSystems, EachDrawsIndependently) {
  const Compiled compiled = compile_text(R"(
    grammar Leaf: lsystem { axiom F(0..1) }
    grammar plant: lsystem { axiom Leaf Leaf })");
  ASSERT_TRUE(compiled.system) << compiled.report;
  const Word word = interpret(*compiled.system, derive(*compiled.system));
  ASSERT_EQ(word.size(), 2u);
  EXPECT_NE(word.parameters(0)[0], word.parameters(1)[0]);
}

/// Answers queries with the number of preceding "F", above a floor at y = 1.
class Counting : public Environment {
 public:
  void answer(const System& system, Word& drawn) const override {
    double height = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
      const std::string& name = system.alphabet.name(drawn.symbol(i));
      if (name == "F") ++height;
      if (name == "?P") drawn.parameters(i)[1] = height;
      if (name == "?D") drawn.parameters(i)[0] = height - 1;
    }
  }
};

TEST(Queries, AreAnsweredAfterEachStep) {
  const SystemPtr system = system_of(R"(axiom A?P(0, 0, 0)
    A > ?P(x, y, z) if y < 3 -> G A
    interpret { G -> F })");
  ASSERT_TRUE(system);
  const Counting turtle;
  DeriveOptions options;
  options.environment = &turtle;
  for (const auto& [steps, expected] :
       {std::pair(0, "A?P(0,0,0)"), std::pair(2, "GGA?P(0,2,0)"), std::pair(9, "GGGA?P(0,3,0)")}) {
    options.steps = steps;
    EXPECT_EQ(to_string(derive(*system, options).word, system->alphabet), expected);
  }
}

}  // namespace
}  // namespace vug::lsystem
