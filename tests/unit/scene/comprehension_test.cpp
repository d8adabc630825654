// SPDX-License-Identifier: Apache-2.0
// Comprehensions and indices: values, order, random choices and limits.
#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

TEST(Comprehension, RunsOverRangesAndLists) {
  EXPECT_EQ(x("[for i in 0..3: i * i]"), "[0, 1, 4, 9]");
  EXPECT_EQ(x("[for i in 1..0: i]"), "[]");
  EXPECT_EQ(x("[for p in [1m, 20cm]: p * 2]"), "[2m, 0.4m]");
  EXPECT_EQ(x("[for p, q in [[1, 2], [3, 4]]: p * q]"), "[2, 12]");
  EXPECT_EQ(x("[for i in 0..2 for j in 0..i: 10 * i + j]"), "[0, 10, 11, 20, 21, 22]");
  EXPECT_EQ(x("[for i in 0..9 if mod(i, 2) == 1 if i > 2: i]"), "[3, 5, 7, 9]");
  EXPECT_EQ(x("[for i in 0..2: [for j in 0..i: j]]"), "[[0], [0, 1], [0, 1, 2]]");
  EXPECT_EQ(value_of("let i = 7\nlet x = [[for i in 0..1: i], i]\n"), "[[0, 1], 7]");
}

TEST(Comprehension, Sorts) {
  EXPECT_EQ(x("[for a in [3, 1, 2] sort by a: a * 10]"), "[10, 20, 30]");
  EXPECT_EQ(x("[for a in [3, 1, 2] if a > 1 sort by -a: a]"), "[3, 2]");
  EXPECT_EQ(x("[for a, b in [[1, \"z\"], [2, \"a\"]] sort by b: a]"), "[2, 1]");
  EXPECT_EQ(x("[for a in [[2, 0], [1, 1], [2, 2]] sort by a[0]: a[1]]"), "[1, 0, 2]");  // stable
  EXPECT_EQ(x("[for a in [1m, 20cm] sort by a: a]"), "[0.2m, 1m]");
}

TEST(Comprehension, IndicesSelectElements) {
  EXPECT_EQ(x("[5, 6, 7][1]"), "6");
  EXPECT_EQ(x("(1m, 2m, 3m)[2]"), "3m");
  EXPECT_EQ(value_of("let a = [[1, 2], [3, 4]]\nlet x = a[1][0] + 1\n"), "4");
  EXPECT_EQ(value_of("def f() = [1, 2]\nlet x = f()[1]\n"), "2");
}

TEST(Comprehension, DrawsOfAnElementDoNotDependOnTheOthers) {
  const std::string three = value_of("let a = [for i in 0..2: 0..1]\nlet x = a[2]\n");
  EXPECT_EQ(three, value_of("let a = [for i in 2..9: 0..1]\nlet x = a[0]\n"));
  EXPECT_EQ(three, value_of("let a = [for i in 0..9 if i == 2: 0..1]\nlet x = a[0]\n"));
  EXPECT_EQ(value_of("let a = [for i in 0..1: 0..1]\nlet x = a[0] == a[1]\n"), "false");
}

TEST(Comprehension, WorkIsLimitedBeforeItIsDone) {
  EXPECT_EQ(x("[for i in 0..1000000000: i]"), "! this would take 1000000001 loop iterations");
  EXPECT_EQ(x("[for i in 0..99999: [for j in 0..99999: j]]"),
            "! this would take 10000000000 loop iterations");
  EXPECT_EQ(x("[for i in 0..99999 for j in 0..9999 for k in 0..9: k]"),
            "! this would take 1000000000 loop iterations");
  EXPECT_EQ(value_of("def g(n) = [for i in 0..n: i]\nlet x = [for i in 0..99999: g(99999)]\n"),
            "! this would take 10000000000 loop iterations, in the call of 'g' at t.vug:2:29");
  EXPECT_EQ(x("[for i in 0..2000 for j in 0..i: j]"),
            "! this takes more than 1000000 loop iterations");
}

TEST(Comprehension, WorkOnLongListsAndTextsCounts) {
  const std::string stop =
      "! the loops around this take too long: its lists or texts are read too often";
  const std::string list = "let s = [for i in 0..400000: i]\n";
  EXPECT_EQ(value_of(list + "let x = [for i in 0..500000: sum(s) + i]\n"), stop);
  EXPECT_EQ(value_of(list + "let x = [for i in 0..500000: len(concat(s, s))]\n"), stop);
  EXPECT_EQ(value_of(list + "let x = len([for i in 0..400000: len(s) + s[i]])\n"), "400001");
  EXPECT_EQ(
      value_of("let t = \"" + std::string(9000, 'a') + "\"\nlet x = [for i in 0..500000: t + i]\n"),
      stop);
}

TEST(Comprehension, FaultyLoopsAreReported) {
  EXPECT_EQ(x("[for i in 0m..2m: i]"), "! a loop counts in whole numbers, not from or to 0m");
  EXPECT_EQ(x("[for i in 5..2: i]"), "! a loop cannot count from 5 down to 2");
  EXPECT_EQ(x("[for i in 3: i]"), "! 'for' needs a list or a range such as 0..5, not a number");
  EXPECT_EQ(x("[for i, j in [1, 2]: i]"), "! 2 variables cannot take a number apart");
  EXPECT_EQ(x("[for i, j in [[1]]: i]"), "! 2 variables cannot take a list of 1 elements apart");
  EXPECT_EQ(x("[for i in [sphere(1m)] sort by i: i]"), "! cannot sort by a field");
  EXPECT_EQ(x("[for i in [1, \"a\"] sort by i: i]"), "! cannot sort by numbers and texts together");
  EXPECT_EQ(x("[1, 2][2]"), "! no element 2 in a list of 2 elements");
  EXPECT_EQ(x("[1, 2][true]"), "! an index is a plain number, not true or false");
  EXPECT_EQ(x("3[0]"), "! only lists and vectors have elements, not a number");
}

}  // namespace
}  // namespace vug::scene
