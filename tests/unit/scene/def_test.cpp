// SPDX-License-Identifier: Apache-2.0
// Functions and `where`: values, arguments, random choices and limits.
#include <vug/scene/check.h>

#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

TEST(Def, ReturnsValuesOfAnyType) {
  EXPECT_EQ(value_of("def f(a, b = 2m) = a + b\nlet x = f(1m)\n"), "3m");
  EXPECT_EQ(value_of("let x = f(1m, b: 20cm)\ndef f(a, b = 2m) = a + b\n"), "1.2m");
  EXPECT_EQ(value_of("def f(n) = [n, n * 2]\nlet x = f(3)\n"), "[3, 6]");
  EXPECT_EQ(value_of("def f(name) = name\nlet x = f(+X)\n"), "+X");
  EXPECT_EQ(value_of("def f(r) = sphere(r)\nlet x = f(1m) + f(2m)\n"), "<field>");
  EXPECT_EQ(value_of("def f(a, b) = a - b\nlet x = 5.f(3)\n"), "2");  // as a method
}

TEST(Def, DefaultsSeeTheParametersBeforeThem) {
  EXPECT_EQ(value_of("def f(a, b = a * 2, c = b + 1) = [a, b, c]\nlet x = f(1)\n"), "[1, 2, 3]");
  EXPECT_EQ(value_of("def f(a, b = a * 2, c = b + 1) = [a, b, c]\nlet x = f(1, c: 0)\n"),
            "[1, 2, 0]");
  EXPECT_EQ(value_of("let b = 7\ndef f(a = b, b = 1) = a + b\nlet x = f()\n"), "8");
}

TEST(Def, ArgumentsHaveTheDimensionOfTheDefault) {
  const std::string f = "def f(size = 30cm, turn = 0deg, way = +X) = [size, turn]\n";
  EXPECT_EQ(value_of(f + "let x = f(2)\n"), "[2m, 0rad]");
  EXPECT_EQ(value_of(f + "let x = f(turn: 2m)\n"),
            "! argument 'turn' of 'f' is an angle, not a length");
  EXPECT_EQ(value_of(f + "let x = f(turn: 30)\n"),
            "! argument 'turn' of 'f' cannot mix a number and an angle");
  EXPECT_EQ(value_of(f + "let x = f(way: 3)\n"),
            "! argument 'way' of 'f' is the name '+X', not a number");
}

TEST(Def, FaultsAreReportedOnceWithTheirCall) {
  EXPECT_EQ(value_of("def f(a) = a + nothere\nlet x = f(1) + f(2)\n"),
            "! unknown name 'nothere', in the call of 'f' at t.vug:2:9");
  EXPECT_EQ(
      value_of("def f(a) = 1 / a\ndef g(a) = f(a)\nlet x = g(0)\n"),
      "! division by zero, in the call of 'f' at t.vug:2:12, in the call of 'g' at t.vug:3:9");
}

TEST(Def, ChainsOfCallsAreLimited) {
  std::string chain, doubling = "def f0() = 1\n";
  for (int i = 300; i > 0; --i)
    chain += "def f" + std::to_string(1000 + i) + "() = f" + std::to_string(1001 + i) + "()\n";
  chain += "def f1301() = 1\n";
  for (int i = 1; i < 60; ++i) {
    const std::string inner = "f" + std::to_string(i - 1) + "()";
    doubling += "def f" + std::to_string(i) + "() = " + inner + " + " + inner + "\n";
  }
  EXPECT_EQ(value_of(chain + "let x = f1001()\n"),
            "! more than 200 functions call each other in a chain");
  EXPECT_EQ(value_of(doubling + "let x = f40()\n"),
            "! this would take 2199023255551 calls of functions");
  EXPECT_EQ(value_of(doubling + "let x = f18()\n"), "262144");
}

/// The height of a value that a function wraps counts as well: fields are evaluated recursively.
TEST(Def, NestedValuesHaveALimitThroughFunctions) {
  std::string text = "def wrap(f) = ";
  for (int i = 0; i < 150; ++i) text += "sphere(";
  text += "f" + std::string(150, ')') + "\nlet a0 = sphere(1m)\n";
  for (int i = 1; i < 100; ++i)
    text += "let a" + std::to_string(i) + " = wrap(a" + std::to_string(i - 1) + ")\n";
  EXPECT_NE(value_of(text + "let x = a99\n").find("! more than 10000 nested operations"),
            std::string::npos);
}

TEST(Def, DrawsDependOnTheCallAndItsNames) {
  const std::string f = "seed 4\ndef f(n) = [0..1, n]\n";
  const std::string alone = value_of(f + "let x = f(1)\n");
  EXPECT_EQ(alone, value_of(f + "# a comment\nlet y = f(1) + f(1)\nlet x = f(1)\n"));
  EXPECT_EQ(alone, value_of("seed 4\ndef g(n) = 0..1\ndef f(n) = [0..1, n]\nlet x = f(1)\n"));
  // Calls of one expression differ.
  EXPECT_EQ(value_of("def f() = 0..1\nlet x = f() == f()\n"), "false");
  // A draw that is an argument is one value.
  EXPECT_EQ(value_of("def f(a) = a == a\nlet x = f(0..1)\n"), "true");
}

TEST(Where, NamesAreEvaluatedOnceAndOnlyIfUsed) {
  EXPECT_EQ(value_of("def f(a) = r + r - 2 * r where r = a..a + 1\nlet x = f(1)\n"), "0");
  EXPECT_EQ(value_of("def f(a) = if(a > 0, b, 0) where b = c / a, c = 6\nlet x = f(0) + f(2)\n"),
            "3");
  EXPECT_EQ(value_of("def f(a) =\n    b\n    where b = a,\n    c = 2\nlet x = f(1)\n"), "1");
  EXPECT_EQ(value_of("def f() = a where a = b, b = a\nlet x = f()\n"),
            "! 'a' depends on itself, in the call of 'f' at t.vug:2:9");
}

TEST(Def, UnusedFunctionsAreReported) {
  const auto warnings = [](const std::string& text) {
    Diagnostics diagnostics;
    check_unused_names(parsed(text), diagnostics);
    std::string out;
    for (const Diagnostic& one : diagnostics.all()) out += one.message + ";";
    return out;
  };
  EXPECT_EQ(warnings("def f(a) = a\n"), "def 'f' is never used;");
  EXPECT_EQ(warnings("let a = 1\ndef f(a) = a\nlet b = f(2)\nvolume v = b\n"),
            "let 'a' is never used;");
  EXPECT_EQ(warnings("let a = 1\nvolume v = [for a in 0..2: a]\n"), "let 'a' is never used;");
  EXPECT_EQ(warnings("let a = 1\nvolume v = [for b in 0..a if b > a: b]\n"), "");
}

}  // namespace
}  // namespace vug::scene
