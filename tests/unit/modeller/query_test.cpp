// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <vug/modeller/query.h>

namespace vug::modeller {
namespace {

using facade::Reason;

TEST(Query, TheEightActionsOfThePaper) {
  std::vector<std::string> names;
  size_t rules = 0;
  for (const Action& action : ripperda()->actions()) {
    names.push_back(action.name);
    rules += action.rules.size();
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "rows(FacadeRow, PartFacade)", "repeat(RepeatedFacade)",
                       "mirror(SymmetricFacadeSide)", "Grid", "RegularGrid", "IdenticalGrid",
                       "RegularIdenticalGrid", "repeat(FacadeElement)"}));
  EXPECT_EQ(rules, 45u - 12u) << "all except those that end in elements, which are implied";
}

TEST(Query, ActionsAreInapplicableToOtherSymbols) {
  const FacadeState state = after(blank(), {"apply 0 rows"});
  const auto enabled = [&](const std::string& node) {
    std::vector<std::string> out;
    for (const ActionChoice& each : actions(state, state.find(node)))
      if (each.choice.reason == Reason::none) out.push_back(each.action->name);
    return out;
  };
  EXPECT_EQ(enabled("0"), std::vector<std::string>{}) << "divided already";
  EXPECT_EQ(enabled("0.0"), (std::vector<std::string>{"IdenticalGrid", "RegularIdenticalGrid",
                                                      "repeat(FacadeElement)"}));
  EXPECT_EQ(enabled("0.1"), (std::vector<std::string>{
                                "repeat(RepeatedFacade)", "mirror(SymmetricFacadeSide)", "Grid",
                                "RegularGrid", "IdenticalGrid", "RegularIdenticalGrid"}));
  EXPECT_EQ(actions(state, state.find("0"))[0].choice.reason, Reason::divided);
  EXPECT_EQ(actions(state, state.find("0.0"))[0].choice.reason, Reason::wrong_symbol);
}

TEST(Query, EveryRuleWithItsReason) {
  const FacadeState start = blank();
  const std::vector<RuleChoice> all = all_choices(start, 0);
  ASSERT_EQ(all.size(), 45u);
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const RuleChoice& c) { return c.reason == Reason::none; }),
            8);
  EXPECT_EQ(choices(start, 0).size(), 8u);
  const FacadeState rows = after(start, {"apply 0 rows"});
  for (const RuleChoice& each : choices(rows, 0)) {
    EXPECT_EQ(each.reason, Reason::divided);
    EXPECT_EQ(each.applied, each.rule == 0);
  }
  // Defaults fit, and equal the result of the rule without numbers.
  const RuleChoice grid = evaluate_rule(after(start, {"apply 0 Grid"}), 1,
                                        ripperda()->find_rule("Grid", "grid(window, door)"));
  std::vector<std::string> names;
  for (const facade::FreeNumber& number : grid.free) {
    names.push_back(number.name);
    for (const double value : number.values) {
      EXPECT_GE(value, number.least - 1e-9) << number.name;
      EXPECT_LE(value, number.most + 1e-9) << number.name;
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"columns", "width", "x", "dx", "rows", "height", "y",
                                             "dy", "door"}));
}

TEST(Query, SmallNodesAndConditions) {
  const StylePtr style = style_of(
      "grammar f: facade {\n axiom A\n A -> rows(3m, B, 1, B)\n A if width > 20m -> window\n"
      "A -> columns(15m, window, 1, wall)\n B(n) -> wall\n B -> columns(40m, wall, 60m, wall)\n"
      "A -> repeat(y, wall, count: 200)\n}\n");
  const FacadeState state(style, {.width = 12, .height = 9});
  std::vector<Reason> reasons;
  for (const RuleChoice& each : all_choices(state, 0)) {
    reasons.push_back(each.reason);
    EXPECT_EQ(each.why.empty(), each.reason == Reason::none);
  }
  EXPECT_EQ(reasons,
            (std::vector<Reason>{Reason::none, Reason::condition, Reason::does_not_fit,
                                 Reason::wrong_symbol, Reason::wrong_symbol, Reason::too_small}));
}

TEST(Query, ArgumentsMatter) {
  const StylePtr style = style_of(
      "grammar f: facade {\n axiom A(1)\n A(n) -> wall\n A(n, k) -> window\n B -> A(1, 2)\n}\n");
  const FacadeState state(style, {});
  EXPECT_EQ(evaluate_rule(state, 0, 0).reason, Reason::none);
  EXPECT_EQ(evaluate_rule(state, 0, 1).reason, Reason::wrong_arguments);
}

TEST(Query, NodesUnderAPoint) {
  const FacadeState state =
      after(blank(), {"apply 0 repeat count=2", "apply 0.0 mirror(SymmetricFacadeSide)",
                      "act 0.0.0 Grid columns=1 rows=1 x=0.5 width=1 y=1 height=2"});
  // Sides of 3 m: windows at 0.5, 4.5, 6.5 and 10.5.
  const struct {
    double x, own;
    bool mirrored;
  } points[] = {{0.75, 0.25, false}, {5.25, 0.25, true}, {6.75, 0.25, false}, {11.25, 0.25, true}};
  for (const auto& point : points) {
    const auto found = hit(state, point.x, 2);
    ASSERT_TRUE(found);
    EXPECT_EQ(state.path(found->node), "0.0.0.0.0");
    EXPECT_NEAR(found->x, point.own, 1e-12);
    EXPECT_NEAR(found->y, 1, 1e-12);
    EXPECT_EQ(found->placement.mirrored, point.mirrored);
  }
  EXPECT_EQ(state.path(hit(state, 0.1, 8)->node), "0.0.0.0") << "next to the window";
  EXPECT_FALSE(hit(state, 13, 1));
  // In a separated mirror image the frame is reversed.
  const FacadeState apart = after(state, {"separate 0.0"});
  const auto found = hit(apart, 5.25, 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(apart.path(found->node), "0.0.1.0.0");
  EXPECT_NEAR(found->x, 0.25, 1e-12);
}

}  // namespace
}  // namespace vug::modeller
