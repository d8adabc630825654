// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/check.h>

#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

TEST(Evaluator, Arithmetic) {
  EXPECT_EQ(x("1 + 2 * 3 ^ 2"), "19");
  EXPECT_EQ(x("-2 ^ 2"), "-4");
  EXPECT_EQ(x("7 - 2 - 1"), "4");
  EXPECT_EQ(x("(1, 2, 3) * 2 + (1m, 0, 0) / 1m"), "(3, 4, 6)");
  EXPECT_EQ(x("-(1, 2, 3)"), "(-1, -2, -3)");
  EXPECT_EQ(x("(30cm, 0.2)"), "[0.3m, 0.2m]");
  EXPECT_EQ(x("1920x1080"), "[1920, 1080]");
  EXPECT_EQ(x("2 ^ 0.5 == sqrt(2)"), "true");
  EXPECT_EQ(x("4 ^ -1"), "0.25");
}

TEST(Evaluator, AnglesPerMetre) {
  EXPECT_EQ(x("0.25rad/m"), "0.25/m");
  EXPECT_EQ(x("(0.5rad / 2m) * 4m"), "1");
  EXPECT_EQ(x("180deg/m == pi/m"), "true");
  EXPECT_EQ(x("90deg * 2m"), "! cannot multiply an angle by a length");
}

TEST(Evaluator, AreasVolumesAndLight) {
  EXPECT_EQ(x("4m * 3m + 50cm2"), "12.005m2");
  EXPECT_EQ(x("2m2 * 50cm"), "1m3");
  EXPECT_EQ(x("(20cm) ^ 2 / 4cm2"), "100.00000000000001");
  EXPECT_EQ(x("sqrt(9m2) + (16m2) ^ 0.5"), "7m");
  EXPECT_EQ(x("dot((1m, 2m, 0), (3m, 0, 0))"), "3m2");
  EXPECT_EQ(x("1000lm / 2m2 + 3lx"), "503lx");
  EXPECT_EQ(x("lm / m2 == 1lx"), "true");
  EXPECT_EQ(x("1 / 20ms"), "50Hz");
  EXPECT_EQ(x("1.5kW + 60W"), "1560W");
  EXPECT_EQ(x("1kW / 2m2"), "500W/m2");
  EXPECT_EQ(x("3 / m2"), "3/m2");
  EXPECT_EQ(x("[300K, 5kg, 2cd]"), "[300K, 5kg, 2cd]");
  EXPECT_EQ(x("2m2 + 1m"), "! cannot add an area and a length");
  EXPECT_EQ(x("2m2 * 3m2"), "! cannot multiply an area by an area");
  EXPECT_EQ(x("800lm + 60W"), "! cannot add a luminous flux and a power");
}

TEST(Evaluator, NamesHideUnitsOfOneLetter) {
  EXPECT_EQ(value_of("let s = 3\nlet x = [s, 2s, 1 / ms]\n"), "[3, 2s, 1000Hz]");
  EXPECT_EQ(value_of("param m = 2\nlet x = m * 1m\n"), "2m");
  EXPECT_EQ(value_of("let W = 5cm\nlet x = W + K / K * cm\n"), "0.060000000000000005m");
  EXPECT_EQ(value_of("let cm = 3\nlet x = 1\n"), "1! 'cm' is a unit and cannot be used as a name");
  Diagnostics diagnostics;
  parse("grammar g {\n  axiom A(1)\n  A(m) if m > 0 -> A(m - 1)\n}\n", "t.vug", diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(Evaluator, Colours) {
  EXPECT_EQ(x("srgb(\"#ffffff\")"), "(1, 1, 1)");
  EXPECT_EQ(x("srgb(\"#FFF\") - srgb(255, 255, 255)"), "(0, 0, 0)");
  EXPECT_EQ(x("length(srgb(\"#c0a080\") - srgb(192, 160, 128))"), "0");
  EXPECT_EQ(x("length(srgb(\"#ca8\") - srgb(\"#ccaa88\"))"), "0");
  // IEC 61966-2-1: the code 128 is 0.21586 of the maximum.
  EXPECT_EQ(x("round(at(srgb(128, 0, 255), 0) * 100000)"), "21586");
  for (const auto& [hsv, code] : {std::pair("0, 1, 1", "#f00"),
                                  {"60deg, 1, 1", "#ff0"},
                                  {"120deg, 1, 1", "#0f0"},
                                  {"180deg, 1, 1", "#0ff"},
                                  {"240deg, 1, 1", "#00f"},
                                  {"300deg, 1, 1", "#f0f"},
                                  {"-60deg, 1, 1", "#f0f"},
                                  {"480deg, 1, 1", "#0f0"},
                                  {"77deg, 0, 1", "#fff"},
                                  {"30deg, 50%, 100%", "#ffbf80"}}) {
    const std::string off =
        std::string("length(hsv(") + hsv + ") - srgb(\"" + code + "\")) < 0.005";
    EXPECT_EQ(x(off), "true") << hsv;
  }
  EXPECT_EQ(x("dot(blackbody(3200K), (0.2126, 0.7152, 0.0722))"), "1");
  EXPECT_EQ(x("at(blackbody(2000), 0) > at(blackbody(6500), 0)"), "true");
  EXPECT_EQ(x("srgb(\"c0a080\")"),
            "! invalid colour \"c0a080\": expected '#' and 3 or 6 hexadecimal digits");
  EXPECT_EQ(x("srgb(0, 0, 256)"), "! the codes of 'srgb' are from 0 to 255, not 256");
  EXPECT_EQ(x("hsv(0, 2, 1)"), "! the saturation of 'hsv' is from 0% to 100%, not 200%");
  EXPECT_EQ(x("blackbody(500K)"),
            "! the temperature of 'blackbody' is from 800K to 40000K, not 500K");
}

TEST(Evaluator, ListFunctions) {
  EXPECT_EQ(x("len([]) + len([1, [2, 3]])"), "2");
  EXPECT_EQ(x("concat([1], [], [2, \"a\"])"), "[1, 2, \"a\"]");
  EXPECT_EQ(x("zip([1, 2], [3m, 4m])"), "[[1, 3m], [2, 4m]]");
  EXPECT_EQ(x("zip([], [])"), "[]");
  EXPECT_EQ(x("sum([1m, 20cm, 3])"), "4.2m");
  EXPECT_EQ(x("sum([3, 1m])"), "4m");
  EXPECT_EQ(x("sum([(1, 0, 0), (0, 2m, 0)])"), "(1m, 2m, 0m)");
  EXPECT_EQ(x("sum([])"), "0");
  EXPECT_EQ(x("min([3m, 20cm]) + max([1m, 2m])"), "2.2m");
  EXPECT_EQ(x("count([1, 2])"), "! unknown function 'count'");
  EXPECT_EQ(x("zip([1, 2], [3])"), "! the lists of 'zip' have 2 and 1 elements");
  EXPECT_EQ(x("sum([1m, 2deg])"), "! cannot add a length and an angle");
  EXPECT_EQ(x("sum([1, \"a\"])"), "! 'sum' adds numbers or vectors, and element 1 is a text");
  EXPECT_EQ(x("min([])"), "! 'min' of an empty list");
  EXPECT_EQ(x("concat([1], 2)"), "! 'concat' takes lists");
}

TEST(Evaluator, TextsAreJoined) {
  EXPECT_EQ(x("\"a\" + \"b\""), "\"ab\"");
  EXPECT_EQ(x("\"n\" + 3 + \", \" + 0.25"), "\"n3, 0.25\"");
  EXPECT_EQ(x("\"\" + 30cm + \" \" + 30deg + \" \" + 52% + \" \" + 2lm + \" \" + 3/m"),
            "\"0.3m 30deg 52% 2lm 3/m\"");
  EXPECT_EQ(x("\"\" + 1rad"), "\"1rad\"");
  EXPECT_EQ(x("2 + \"nd\""), "\"2nd\"");
  EXPECT_EQ(x("\"a\" + [1]"), "! cannot apply '+' to a text and a list");
  EXPECT_EQ(x("\"a\" - \"b\""), "! cannot apply '-' to a text and a text");
  EXPECT_EQ(x("\"a\" + nothere"), "! unknown name 'nothere'");
}

TEST(Evaluator, LogicIsLazy) {
  EXPECT_EQ(x("true or 1 / 0 > 1"), "true");
  EXPECT_EQ(x("false and nothere"), "false");
  EXPECT_EQ(x("if(1 < 2, 3, 1 / 0)"), "3");
  EXPECT_EQ(x("not 1 == 2"), "true");
  EXPECT_EQ(x("\"a\" == \"a\" and +X != -X"), "true");
}

TEST(Evaluator, Functions) {
  EXPECT_EQ(x("min(3, 1, 2) + max(1, 2)"), "3");
  EXPECT_EQ(x("clamp(5m, 0, 200cm)"), "2m");
  EXPECT_EQ(x("mix(1m, 3m, 25%)"), "1.5m");
  EXPECT_EQ(x("mix((0, 0, 0), (2, 4, 6), 0.5)"), "(1, 2, 3)");
  EXPECT_EQ(x("floor(-1.5) + ceil(1.2) + round(2.5)"), "3");
  EXPECT_EQ(x("mod(-1, 4)"), "3");
  EXPECT_EQ(x("sin(90deg) + cos(0) + tan(0)"), "2");
  EXPECT_EQ(x("abs(-2cm)"), "0.02m");
  EXPECT_EQ(x("length((3m, 4m, 0))"), "5m");
  EXPECT_EQ(x("dot((1, 2, 3), (1m, 1m, 1m))"), "6m");
  EXPECT_EQ(x("cross((1, 0, 0), (0, 1, 0))"), "(0, 0, 1)");
  EXPECT_EQ(x("normalize((0, 2m, 0))"), "(0, 1, 0)");
  EXPECT_EQ(x("exp(log(2)) > 1.999 and pow(2, 10) == 1024"), "true");
  EXPECT_EQ(x("len([1, 2, 3]) + at([4, 5], 1) + at((7, 8, 9), 2)"), "17");
  EXPECT_EQ(x("round(2m / 1m)"), "2");
  EXPECT_EQ(x("2.5.round()"), "3");
}

TEST(Evaluator, MethodsAreCallsWithTheReceiverFirst) {
  EXPECT_EQ(x("4.max(7)"), "7");
  EXPECT_EQ(x("(1, 0, 0).dot((2, 0, 0)).clamp(0, 1)"), "1");
}

TEST(Evaluator, ObjectsArePassedToTheResolver) {
  EXPECT_EQ(x("sphere(1m) - box(2m) + torus(1m)"), "<field>");
  EXPECT_EQ(x("sphere(1m) * 2"), "! cannot apply '*' to a field and a number");
  EXPECT_EQ(x("-sphere(1m)"), "! cannot apply '-' to a field");
}

TEST(Evaluator, ResolverErrorsBecomeDiagnostics) {
  struct Thrower : Resolver {
    std::optional<Value> call(const std::string&, const Arguments&, const SourceLocation&,
                              const CallContext&, Diagnostics&) override {
      throw Error(ErrorCode::bad_input, "no such thing");
    }
  } resolver;
  Diagnostics diagnostics;
  const Document document = parsed("let x = thing(1)\n");
  Evaluator evaluator(document, resolver, diagnostics);
  evaluator.check_all();
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].where, (SourceLocation{"t.vug", 1, 9, 1, 17}));
}

TEST(Evaluator, RejectedNamesHaveTheNearestKnownNameAsHint) {
  struct Strict : Resolver {
    std::optional<Value> call(const std::string&, const Arguments& given, const SourceLocation&,
                              const CallContext&, Diagnostics& diagnostics) override {
      diagnostics.error(given[0].where, "no number");
      return Value();
    }
  } resolver;
  Diagnostics diagnostics;
  const Document document = parsed("param radius = 1\nlet x = ball(raduis)\n");
  Evaluator evaluator(document, resolver, diagnostics);
  evaluator.check_all();
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].hint, "did you mean 'radius'?");
}

TEST(Evaluator, LetsAndParamsInAnyOrder) {
  EXPECT_EQ(value_of("let x = a * 2\nlet a = B + 1\nparam B = 3\n"), "8");
}

TEST(Evaluator, UnknownNamesStayNamesUntilUsed) {
  EXPECT_EQ(x("triangle"), "triangle");
  EXPECT_EQ(x("[a, b, +X, -Z]"), "[a, b, +X, -Z]");
  EXPECT_EQ(x("triangle + 1"), "! unknown name 'triangle'");
  EXPECT_EQ(x("+other"), "! unknown name 'other'");
}

TEST(Evaluator, ScopesHideGlobals) {
  const Document document = parsed("param n = 1\nlet x = n + m1\n");
  Resolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics);
  Scope outer{{{"n", Value(10)}, {"m1", Value(1)}}, nullptr};
  const Scope inner{{{"n", Value(20)}}, &outer};
  const Expr& expr = *document.lets[0].value;
  EXPECT_EQ(to_string(evaluator.eval(expr, evaluator.root(), &outer)), "11");
  EXPECT_EQ(to_string(evaluator.eval(expr, evaluator.root(), &inner)), "21");
}

TEST(Evaluator, OverridesTakeTheDimensionOfTheDefault) {
  const std::string text = "param SIZE = 30cm in 1cm..3m\nparam LB = +X\nlet x = [SIZE, LB]\n";
  EXPECT_EQ(value_of(text), "[0.3m, +X]");
  EXPECT_EQ(value_of(text, {{{"SIZE", "2"}, {"LB", "-Z"}}, {}}), "[2m, -Z]");
  EXPECT_EQ(value_of(text, {{{"SIZE", "1ft * 2"}}, {}}), "[0.6096m, +X]");
  EXPECT_EQ(value_of(text, {{{"SIZE", "5"}}, {}}), "! param 'SIZE' is 5m, outside 0.01m..3m");
  EXPECT_EQ(value_of(text, {{{"SIZE", "5deg"}}, {}}), "! param 'SIZE' is a length, not an angle");
  EXPECT_EQ(value_of(text, {{{"LB", "4"}}, {}}), "! param 'LB' is the name '+X', not a number");
}

TEST(Evaluator, AnInvalidOverrideIsOneError) {
  const std::string text = "param R = 1m in 10cm..3m\nlet x = R\n";
  EXPECT_EQ(value_of(text, {{{"R", "1e999"}}, {}}), "1m! the number 1e999 is too large");
  EXPECT_EQ(value_of(text, {{{"R", "0 parsec"}}, {}}),
            "1m! expected the end of the expression, found 'parsec'");
  EXPECT_EQ(value_of(text, {{{"R", "0parsec"}}, {}}), "1m! unknown unit 'parsec'");
}

TEST(Evaluator, ParamsDescribeThemselvesForUserInterfaces) {
  const Document document = parsed("param MP = 52% in 0..100% \"morph\"\nlet x = MP\n");
  Resolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics, {{{"MP", "30%"}}, {}});
  const ParamValue& mp = evaluator.params().at(0);
  EXPECT_EQ(mp.param->doc, "morph");
  EXPECT_EQ(mp.value.get<Number>()->value, 0.3);
  EXPECT_EQ(mp.fallback.get<Number>()->value, 0.52);
  EXPECT_EQ(mp.high.get<Number>()->value, 1);
}

TEST(Evaluator, ParamsHiddenByFormalsAreUnused) {
  Diagnostics diagnostics;
  const Document document = parsed(
      "param n = 1\nparam k = 2\ngrammar g {\n  axiom A(k)\n  A(n) if n > 0 -> A(n - 1)\n}\n");
  check_unused_names(document, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].message, "param 'n' is never used");
  EXPECT_FALSE(diagnostics.has_errors());
}

/// The errors of x = `last` after a chain of lets, each made from the previous one, a0 to a59.
std::string end_of_chain(const std::string& first, const std::string& before,
                         const std::string& between, const std::string& after,
                         const std::string& last) {
  std::string text = "let a0 = " + first + "\n";
  for (int i = 1; i < 60; ++i) {
    const std::string name = "a" + std::to_string(i - 1);
    text += "let a" + std::to_string(i) + " = " + before + name + between + name + after + "\n";
  }
  return value_of(text + "let x = " + last + "\n");
}

TEST(Evaluator, GrowingValuesAreRejected) {
  EXPECT_EQ(end_of_chain("[1, 1]", "[", ", ", "]", "a59"),
            "! the list would have 1048575 elements, more than 1000000");
  EXPECT_EQ(end_of_chain("[1, 1]", "concat(", ", ", ")", "a59"),
            "! the list would have 1048577 elements, more than 1000000");
  EXPECT_EQ(end_of_chain("[1, 1]", "zip(", ", ", ")", "a59"),
            "! the list would have 1048575 elements, more than 1000000");
  EXPECT_EQ(end_of_chain("\"ab\"", "", " + ", "", "a59"),
            "! the text would have 1048576 bytes, more than 1000000");
}

TEST(Evaluator, LongChainsOfLetsAreRejected) {
  std::string text = "let a0 = 1\n";
  for (int i = 1; i < 5000; ++i)
    text += "let a" + std::to_string(i) + " = a" + std::to_string(i - 1) + "\n";
  EXPECT_EQ(value_of(text + "let x = a4999\n"),
            "! more than 200 names depend on each other in a chain");
}

/// The errors of a chain of lets in which each one depends on the previous one, as `# + 1`.
std::vector<Diagnostic> faults_of_chain(int lets, const std::string& first,
                                        const std::string& next) {
  std::string text = "let a0 = " + first + "\n";
  for (int i = 1; i < lets; ++i) {
    text.append("let a").append(std::to_string(i)).append(" = ").append(next);
    text.replace(text.rfind('#'), 1, 'a' + std::to_string(i - 1)).append("\n");
  }
  Diagnostics diagnostics;
  const Document document = parse(text, "t.vug", diagnostics);
  FakeResolver resolver;
  Evaluator evaluator(document, resolver, diagnostics, {});
  evaluator.check_all();
  return diagnostics.all();
}

TEST(Evaluator, NestedValuesHaveAMaximumDepth) {
  EXPECT_TRUE(
      faults_of_chain(20000, "1", "# + 1").empty());  // a number does not refer to its inputs
  EXPECT_TRUE(faults_of_chain(5000, "[1]", "[#]").empty());
  EXPECT_TRUE(faults_of_chain(2500, "[1]", "[[[#]]]").empty());
  for (const auto& [lets, next] : {std::pair(5001, "[#]"), {2502, "[[[#]]]"}, {9000, "[#]"}}) {
    const std::vector<Diagnostic> found = faults_of_chain(lets, "[1]", next);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].message, "more than 10000 nested operations");
    EXPECT_EQ(found[0].where.line, std::string(next) == "[#]" ? 5001 : 2501);
  }
}

}  // namespace
}  // namespace vug::scene
