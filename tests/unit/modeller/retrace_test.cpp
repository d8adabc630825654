#include "desk.h"

#include <vug/modeller/retrace.h>

namespace vug::modeller {
namespace {

/// The state after the edits of what is read back of a state's tree.
State again(const State& state, Retraced& way) {
  const facade::Tree tree = read_tree(facade::tree_json(state.tree()), "tree.json");
  way = retraced(State(state.style_ptr(), state.sheet()), tree);
  State out(state.style_ptr(), state.sheet());
  for (const Edit& edit : way.edits) out = edited(out, edit);
  return out;
}

TEST(Retrace, WhatIsModelledComesBack) {
  const State state = after(
      blank(),
      {"apply 0 rows heights=3", "apply 0.0 repeat count=3 widths=2.5,4", "apply 0.0.0 window",
       "apply 0.0.1 door", "apply 0.1 mirror(SymmetricFacadeSide, SymmetricFacadeMiddle) width=3.3",
       "act 0.1.0 Grid columns=2 rows=2 width=1 height=1.2 x=0.5 dx=1.6 y=0.7 dy=2.5",
       "toggle 0.1.0.0 column=1 row=0", "act 0.1.1 RegularIdenticalGrid columns=2 rows=2 door=1"});
  Retraced way;
  const State back = again(state, way);
  EXPECT_EQ(way.elements, facade::standing(state.tree()).size());
  EXPECT_EQ(way.moved, 0u) << way.farthest;
  EXPECT_EQ(way.missing, 0u);
  EXPECT_EQ(facade::standing(back.tree()).size(), way.elements);
  EXPECT_EQ(back.tree().nodes.size(), state.tree().nodes.size());
}

TEST(Retrace, SaysWhatTheRulesCannot) {
  const State state = after(blank(), {"act 0 RegularIdenticalGrid columns=3 rows=2"});
  facade::Tree tree = state.tree();
  for (facade::Node& node : tree.nodes)
    if (node.element) node.copies[0].x += 0.3;
  const Retraced way = retraced(blank(), tree);
  EXPECT_EQ(way.elements, 6u);
  EXPECT_EQ(way.missing, 0u);
  EXPECT_GE(way.moved, 1u);
  EXPECT_NEAR(way.farthest, 0.3, 0.16);
}

/// "line:column: message (hint)"
std::string fault(const std::string& text) {
  try {
    retraced(blank(), read_tree(text, "tree.json"));
  } catch (const Error& error) {
    return std::to_string(error.where().line) + ":" + std::to_string(error.where().column) + ": " +
           error.what() + (error.hint().empty() ? "" : " (" + error.hint() + ")");
  }
  return "";
}

TEST(Retrace, BrokenTrees) {
  const std::string good =
      facade::tree_json(after(blank(), {"act 0 Grid columns=2 rows=2"}).tree());
  EXPECT_EQ(fault(good), "");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return fault(text);
  };
  EXPECT_EQ(fault("{}").substr(0, 33), "1:1: this is no tree of a facade ");
  EXPECT_NE(fault(good.substr(0, good.size() / 2)).find("this is no JSON"), std::string::npos);
  EXPECT_NE(
      changed("\"parent\": -1", "\"parent\": 3").find("/nodes/0/parent: node 0 has no such parent"),
      std::string::npos);
  EXPECT_NE(
      changed("\"element\": \"window\"", "\"element\": \"windoe\"").find("did you mean 'window'"),
      std::string::npos);
  EXPECT_NE(changed("12.0,", "\"a\",").find("a number is needed here"), std::string::npos);
  EXPECT_NE(changed("Facade -> Grid", "Facade -> Grit").find("the grammar 'ripperda' has no rule"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::modeller
