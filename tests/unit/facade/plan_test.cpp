// SPDX-License-Identifier: Apache-2.0
// Derivations by plans.
#include "derived.h"

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

PlanPtr rule(int number, NumberValues numbers = {}, std::map<PartKey, PlanPtr> parts = {}) {
  Plan out;
  out.rule = number;
  out.numbers = std::move(numbers);
  out.parts = std::move(parts);
  return std::make_shared<const Plan>(std::move(out));
}

/// Rules and derivations of plans for the axiom's symbol; 12 m x 9 m.
struct Desk {
  explicit Desk(const std::string& block)
      : document(scene::parse("grammar f: facade {\n" + block + "\n}\n", "test.vug", diagnostics)),
        rules(read_rules(document, document.grammars.back(), diagnostics)),
        evaluator(document, resolver, diagnostics) {
    EXPECT_FALSE(diagnostics.has_errors());
  }
  PlannedDerivation of(PlanPtr plan, double least = 0.05) {
    PlanOptions planning{{}, least};
    planning.plan.parts[{}] = std::move(plan);
    auto made = derive(rules, evaluator, DeriveOptions(), planning);
    EXPECT_TRUE(made.has_value());
    return made.value_or(PlannedDerivation());
  }
  /// The error of a plan that cannot be followed.
  InfeasiblePlan refused(PlanPtr plan, double least = 0.05) {
    try {
      of(std::move(plan), least);
    } catch (const InfeasiblePlan& error) {
      return error;
    }
    ADD_FAILURE() << "no error";
    return {Reason::none, "", "nothing was refused"};
  }

  Diagnostics diagnostics;
  scene::Document document;
  Rules rules;
  scene::Resolver resolver;
  scene::Evaluator evaluator;
};

std::vector<Rect> sorted_rects(const Tree& tree) {
  std::vector<Rect> out;
  for (const ElementInstance& one : element_instances(tree)) out.push_back(one.rect);
  std::sort(out.begin(), out.end(),
            [](const Rect& a, const Rect& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  return out;
}

TEST(Plan, WithoutARuleNodesStayOpen) {
  Desk desk("axiom A\n A -> rows(B, C)\n B -> window\n C -> wall");
  const PlannedDerivation nothing = desk.of(nullptr);
  ASSERT_EQ(nothing.derived.tree.nodes.size(), 1u);
  EXPECT_TRUE(nothing.derived.tree.nodes[0].stuck);
  const PlannedDerivation split = desk.of(rule(0, {{"heights", {4}}}));
  ASSERT_EQ(split.derived.tree.nodes.size(), 3u);
  expect_rect(split.derived.tree.nodes[2].rect, 0, 4, 12, 5);
  EXPECT_TRUE(split.derived.tree.nodes[1].stuck && split.derived.tree.nodes[2].stuck);
  EXPECT_FALSE(split.derived.tree.nodes[0].stuck);
  ASSERT_EQ(split.nodes[0].free.size(), 1u);
  EXPECT_EQ(split.nodes[0].free[0].name, "heights");
  EXPECT_EQ(split.nodes[0].free[0].values, (std::vector<double>{4, 5}));
  EXPECT_TRUE(split.nodes[0].free[0].fixed);
  EXPECT_EQ(split.nodes[2].place, (PartKey{0, 1, 0, 1}));
}

TEST(Plan, NumbersOfAGrid) {
  Desk desk("axiom A\n A -> grid(window)\n A -> grid(window, regular: false, identical: false)");
  const PlannedDerivation usual = desk.of(rule(0));
  EXPECT_EQ(element_instances(usual.derived.tree).size(), 15u) << "every 2.4 m, every 3 m";
  const PlannedDerivation fixed = desk.of(
      rule(0, {{"columns", {4}}, {"rows", {2}}, {"x", {0.5}}, {"width", {1.5}}, {"dx", {3}}}));
  EXPECT_EQ(element_instances(fixed.derived.tree).size(), 8u);
  EXPECT_NEAR(sorted_rects(fixed.derived.tree)[7].x, 9.5, 1e-12);
  const PlannedDerivation uneven = desk.of(
      rule(1, {{"columns", {3}}, {"rows", {1}}, {"x", {1}}, {"width", {1}}, {"dx", {2, 5}}}));
  const std::vector<Rect> rects = sorted_rects(uneven.derived.tree);
  ASSERT_EQ(rects.size(), 3u);
  EXPECT_NEAR(rects[1].x, 3, 1e-12);
  EXPECT_NEAR(rects[2].x, 8, 1e-12);
}

TEST(Plan, InvalidNumbersAreNamed) {
  Desk desk("axiom A\n A -> grid(window)\n A -> rows(B, B)\n B -> wall");
  const auto number = [&](NumberValues fixed) {
    return desk.refused(rule(0, std::move(fixed))).number();
  };
  EXPECT_EQ(number({{"columns", {0}}}), "columns");
  EXPECT_EQ(number({{"columns", {2.5}}}), "columns");
  EXPECT_EQ(number({{"columns", {std::nan("")}}}), "columns");
  EXPECT_EQ(number({{"columns", {2, 3}}}), "columns");
  EXPECT_EQ(number({{"columns", {3}}, {"width", {5}}}), "width");
  EXPECT_EQ(number({{"columns", {3}}, {"width", {2}}, {"dx", {1}}}), "dx");
  EXPECT_EQ(number({{"columns", {3}}, {"width", {2}}, {"dx", {9}}}), "dx");
  EXPECT_EQ(number({{"columns", {3}}, {"x", {-1}}}), "x");
  const InfeasiblePlan unknown = desk.refused(rule(0, {{"columnx", {3}}}));
  EXPECT_EQ(unknown.number(), "columnx");
  EXPECT_EQ(unknown.hint(), "did you mean 'columns'?");
  EXPECT_EQ(desk.refused(rule(1, {{"heights", {4, 4}}})).number(), "heights");
  EXPECT_EQ(desk.refused(rule(1, {{"heights", {10}}})).number(), "heights");
  EXPECT_EQ(desk.refused(rule(1, {{"heights", {8.99}}})).reason(), Reason::too_small);
}

TEST(Plan, RulesThatDoNotApply) {
  Desk desk(
      "axiom A\n A if height > 10m -> window\n A -> B(1)\n B(n) -> wall\n B(n, k) -> door\n"
      "C -> columns(20m, wall, 1, window)\n A -> C");
  EXPECT_EQ(desk.refused(rule(0)).reason(), Reason::condition);
  EXPECT_EQ(desk.refused(rule(1, {}, {{{}, rule(3)}})).reason(), Reason::wrong_arguments);
  EXPECT_EQ(desk.refused(rule(1, {}, {{{}, rule(4)}})).reason(), Reason::wrong_symbol);
  const InfeasiblePlan wide = desk.refused(rule(5, {}, {{{}, rule(4)}}));
  EXPECT_EQ(wide.reason(), Reason::does_not_fit);
  EXPECT_NE(std::string(wide.what()).find("they need 20m of 12m"), std::string::npos);
}

TEST(Plan, SeparatedCopiesKeepTheirPlacements) {
  // An asymmetric side, mirrored within a mirror within a repeat.
  Desk desk(
      "axiom A\n A -> repeat(x, B)\n B -> mirror(C, D)\n C -> mirror(D)\n"
      "D -> columns(1, window, 2, wall)");
  const PlanPtr d = rule(3);
  const PartKey first{0, 0, 0, 0}, middle{0, 1, 0, 0};
  const PlanPtr c = rule(2, {}, {{first, d}});
  const PlanPtr b = rule(1, {{"width", {1}}}, {{first, c}, {middle, d}});
  const PlanPtr a = rule(0, {{"count", {3}}}, {{first, b}});
  const PlannedDerivation whole = desk.of(a);

  const auto broken = [](const PlanPtr& plan, const PlanPtr& part) {
    Plan out = *plan;
    out.apart = true;
    out.parts[{0, 0, 0, 0}] = out.parts[{0, 0, 1, 0}] = out.parts[{0, 0, 2, 0}] = part;
    return std::make_shared<const Plan>(std::move(out));
  };
  const PlanPtr all = broken(a, broken(b, broken(c, d)));
  const PlannedDerivation apart = desk.of(all);
  EXPECT_GT(apart.derived.tree.nodes.size(), 3 * whole.derived.tree.nodes.size());
  for (const Node& node : apart.derived.tree.nodes) EXPECT_TRUE(node.copies.empty());
  const std::vector<Rect> one = sorted_rects(whole.derived.tree);
  const std::vector<Rect> other = sorted_rects(apart.derived.tree);
  ASSERT_EQ(one.size(), other.size());
  for (size_t i = 0; i < one.size(); ++i)
    expect_rect(other[i], one[i].x, one[i].y, one[i].width, one[i].height);
  const auto mirrored = [](const Tree& tree) {
    const std::vector<ElementInstance> seen = element_instances(tree);
    return std::count_if(seen.begin(), seen.end(),
                         [](const ElementInstance& s) { return s.mirrored; });
  };
  EXPECT_EQ(mirrored(whole.derived.tree), mirrored(apart.derived.tree));
  EXPECT_GT(mirrored(apart.derived.tree), 0);
  // Differs only at the outside: mirrors within a rotated frame.
  const std::vector<Rect> partly = sorted_rects(desk.of(broken(a, broken(b, c))).derived.tree);
  ASSERT_EQ(partly.size(), one.size());
  for (size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(partly[i].x, one[i].x, 1e-12);
}

TEST(Plan, EmptyCells) {
  Desk desk("axiom A\n A -> grid(window, door, identical: false)");
  Plan plan;
  plan.rule = 0;
  plan.numbers = {{"columns", {3}}, {"rows", {2}}, {"door", {1}}};
  plan.off = {{0, 0}, {2, 1}};
  const PlannedDerivation made = desk.of(std::make_shared<const Plan>(plan));
  EXPECT_EQ(element_instances(made.derived.tree).size(), 4u) << "three windows and the door";
}

TEST(Plan, NumbersOfASecondSplit) {
  Desk desk("axiom A\n A -> columns(B, B) wall rows(B, columns(B, B))\n B -> window");
  const PlannedDerivation made = desk.of(rule(0, {{"widths", {3}}, {"2.heights", {2}}}));
  ASSERT_EQ(made.nodes[0].free.size(), 2u);
  EXPECT_EQ(made.nodes[0].free[1].name, "2.heights");
  EXPECT_EQ(made.nodes[0].free[1].values, (std::vector<double>{2, 7}));
  // The inner split is a separate node.
  const PartKey inner{2, 1, 0, 1};
  const PlannedDerivation fixed = desk.of(rule(0, {}, {{inner, rule(-1, {{"widths", {5}}})}}));
  expect_rect(fixed.derived.tree.nodes.back().rect, 5, 3.5, 7, 5.5);
}

}  // namespace
}  // namespace vug::facade
