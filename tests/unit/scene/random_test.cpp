// SPDX-License-Identifier: Apache-2.0
// Seeded random choices and their dependence on seed and path.
#include <cmath>
#include <map>

#include "fake_resolver.h"
#include "parsing.h"

namespace vug::scene {
namespace {

/// The value of a let for a seed.
Value drawn(const std::string& text, const std::string& let, uint64_t seed = 1) {
  const Document document = parsed(text);
  FakeResolver resolver;
  Diagnostics diagnostics;
  EvaluatorOptions options;
  options.seed = seed;
  Evaluator evaluator(document, resolver, diagnostics, options);
  const Value value = evaluator.eval(*document.find_let(let)->value, evaluator.root().at(let));
  EXPECT_EQ(report(diagnostics, document.sources), "");
  return value;
}

double let_value(const std::string& text, const std::string& let = "a", uint64_t seed = 1) {
  return drawn(text, let, seed).get<Number>()->value;
}

TEST(Random, DependsOnSeedAndPathOnly) {
  const double first = let_value("let a = 0..1");
  EXPECT_EQ(first, let_value("let a = 0..1"));
  EXPECT_EQ(first, let_value("let b = 0..1\n\n# more\nlet a = 0 .. 1\nlet c = 0..1"));
  EXPECT_NE(first, let_value("let a = 0..1", "a", 2));
  EXPECT_NE(first, let_value("let b = 0..1", "b"));
}

/// Identities of the ranges of an expression, by the path of names that leads to them.
void paths(const Expr& expr, const std::string& way, std::map<std::string, uint64_t>& out) {
  if (expr.kind == ExprKind::range) out[way] = expr.path;
  const bool call = expr.kind == ExprKind::call;
  for (const Operand& part : expr.operands)
    paths(*part.value, call ? way + "/" + expr.text + "." + part.name : way, out);
}

uint64_t identity(const std::string& expression, const std::string& way) {
  Diagnostics diagnostics;
  std::map<std::string, uint64_t> all;
  paths(*parse_expression(expression, "t", diagnostics), "", all);
  EXPECT_EQ(all.count(way), 1u) << expression;
  return all[way];
}

TEST(Random, SiblingsOfOtherNamesChangeNothing) {
  const std::string way = "/sphere.radius";
  const uint64_t alone = identity("sphere(radius: 1..2)", way);
  EXPECT_EQ(alone, identity("box(size: 1..2) + sphere(radius: 1..2)", way));
  EXPECT_EQ(alone, identity("sphere(center: (0, 0..1, 0), radius: 1..2) - torus(tube: 1..2)", way));
  EXPECT_EQ(alone, identity("[4..5, sphere(radius: 1..2)]", way));
  // Of two with the same name, `paths` keeps the last one: they differ.
  EXPECT_NE(alone, identity("sphere(radius: 1..2) + sphere(radius: 1..2)", way));
  // An appended method does not change its receiver.
  Diagnostics diagnostics;
  const ExprPtr moved = parse_expression("sphere(radius: 1..2).move(0..1)", "t", diagnostics);
  EXPECT_EQ(moved->operands[0].value->operands[0].value->path, alone);
}

TEST(Random, IsUniform) {
  // 40,000 draws into 16 bins: chi-square with 15 degrees of freedom stays below 37.7 with
  // probability 0.999.
  const Document document = parsed("let a = 2..6\n");
  Resolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics);
  std::vector<int> bins(16);
  const int draws = 40000;
  for (int i = 0; i < draws; ++i) {
    const Value value =
        evaluator.eval(*document.lets[0].value, evaluator.root().at(static_cast<uint64_t>(i)));
    const double u = (value.get<Number>()->value - 2) / 4;
    ASSERT_TRUE(u >= 0 && u < 1);
    ++bins[static_cast<size_t>(u * 16)];
  }
  double chi2 = 0;
  for (const int count : bins) chi2 += std::pow(count - draws / 16.0, 2) / (draws / 16.0);
  EXPECT_LT(chi2, 37.7);
}

TEST(Random, CountsAreWholeAndReachBothEnds) {
  const Document document = parsed("let a = 2..5\nlet b = 3\nlet c = 2.5\n");
  Resolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics);
  std::vector<int> seen(8);
  for (uint64_t i = 0; i < 400; ++i)
    ++seen[static_cast<size_t>(*evaluator.count(*document.lets[0].value, evaluator.root().at(i)))];
  EXPECT_EQ(seen[0] + seen[1] + seen[6] + seen[7], 0);
  for (int count = 2; count <= 5; ++count) EXPECT_GT(seen[static_cast<size_t>(count)], 60);
  EXPECT_EQ(*evaluator.count(*document.lets[1].value, evaluator.root()), 3);
  EXPECT_FALSE(evaluator.count(*document.lets[2].value, evaluator.root()));
  EXPECT_EQ(diagnostics.all().size(), 1u);
}

TEST(Random, PickIsFairAndLazy) {
  const Document document = parsed("let a = pick(1, 2, 3)\nlet b = pick([1, 2, 3])\n");
  Resolver resolver;
  Diagnostics diagnostics;
  Evaluator evaluator(document, resolver, diagnostics);
  for (const Let& let : document.lets) {
    std::vector<int> seen(4);
    for (uint64_t i = 0; i < 3000; ++i) {
      const Value value = evaluator.eval(*let.value, evaluator.root().at(i));
      ++seen[static_cast<size_t>(value.get<Number>()->value)];
    }
    // Three standard deviations of a binomial of 3000 and 1/3 are 78.
    for (int choice = 1; choice <= 3; ++choice)
      EXPECT_NEAR(seen[static_cast<size_t>(choice)], 1000, 78);
  }
}

TEST(Random, VectorsDrawEachComponent) {
  const Value value = drawn("let a = (0, 1m, 2)..(1, 2, 3)", "a");
  const auto* v = value.get<Value::Vector>();
  ASSERT_TRUE(v);
  EXPECT_EQ(v->dimension, Dimension::length);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(v->value[axis], axis);
    EXPECT_LT(v->value[axis], axis + 1);
  }
}

}  // namespace
}  // namespace vug::scene
