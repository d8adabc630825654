// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <vug/facade/grammar_output.h>
#include <vug/modeller/tree_to_edits.h>

namespace vug::modeller {
namespace {

/// The state after the edits computed from a state's tree.
FacadeState again(const FacadeState& state, TreeEdits& result) {
  const facade::Tree tree = read_tree(facade::tree_json(state.tree()), "tree.json");
  result = tree_to_edits(FacadeState(state.style_ptr(), state.canvas()), tree);
  FacadeState out(state.style_ptr(), state.canvas());
  for (const Edit& edit : result.edits) out = perform_edit(out, edit);
  return out;
}

TEST(TreeToEdits, ReproducesModelledFacades) {
  const FacadeState state = after(
      blank(),
      {"apply 0 rows heights=3", "apply 0.0 repeat count=3 widths=2.5,4", "apply 0.0.0 window",
       "apply 0.0.1 door", "apply 0.1 mirror(SymmetricFacadeSide, SymmetricFacadeMiddle) width=3.3",
       "act 0.1.0 Grid columns=2 rows=2 width=1 height=1.2 x=0.5 dx=1.6 y=0.7 dy=2.5",
       "toggle 0.1.0.0 column=1 row=0", "act 0.1.1 RegularIdenticalGrid columns=2 rows=2 door=1"});
  TreeEdits result;
  const FacadeState back = again(state, result);
  EXPECT_EQ(result.elements, facade::element_instances(state.tree()).size());
  EXPECT_EQ(result.displaced, 0u) << result.max_distance;
  EXPECT_EQ(result.missing, 0u);
  EXPECT_EQ(facade::element_instances(back.tree()).size(), result.elements);
  EXPECT_EQ(back.tree().nodes.size(), state.tree().nodes.size());
}

TEST(TreeToEdits, ReportsWhatTheRulesCannotExpress) {
  const FacadeState state = after(blank(), {"act 0 RegularIdenticalGrid columns=3 rows=2"});
  facade::Tree tree = state.tree();
  for (facade::Node& node : tree.nodes)
    if (node.element) node.copies[0].x += 0.3;
  const TreeEdits result = tree_to_edits(blank(), tree);
  EXPECT_EQ(result.elements, 6u);
  EXPECT_EQ(result.missing, 0u);
  EXPECT_GE(result.displaced, 1u);
  EXPECT_NEAR(result.max_distance, 0.3, 0.16);
}

TEST(TreeToEdits, PositionsOfUnevenGridsTakePrecedenceOverSizes) {
  const FacadeState state = after(
      blank(), {"act 0 IdenticalGrid columns=4 rows=1 width=1 height=1 x=1 dx=1.5,1.5,6.9999"});
  facade::Tree tree = state.tree();
  for (facade::Node& node : tree.nodes)
    // Wider than the distance to the next window, and beyond the border.
    if (node.element) node.rect.width = 2;
  const TreeEdits result = tree_to_edits(blank(), tree);
  FacadeState back = blank();
  for (const Edit& edit : result.edits) back = perform_edit(back, edit);
  const std::vector<facade::Rect> at = rects(back);
  ASSERT_EQ(at.size(), 4u);
  const double begins[] = {1, 2.5, 4, 10.9999};
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(at[i].x, begins[i], 1e-6);
  EXPECT_NEAR(at[0].width, 1, 0.01);
  EXPECT_NEAR(result.max_distance, 1, 0.01);
}

TEST(TreeToEdits, AcceptsTheGrammarWrittenFromTheTree) {
  const FacadeState state =
      after(blank(), {"apply 0 rows heights=3", "apply 0.0 repeat count=3 widths=2.5,4",
                      "apply 0.0.0 window", "apply 0.0.1 door", "apply 0.0.2 window",
                      "act 0.1 Grid columns=3 rows=2 dx=2,5"});
  const StylePtr own =
      style_of(facade::grammar_text(state.tree(), {.name = "own", .columns = false}));
  const TreeEdits result = tree_to_edits(FacadeState(own, state.canvas()), state.tree());
  EXPECT_EQ(result.elements, facade::element_instances(state.tree()).size());
  EXPECT_EQ(result.displaced + result.missing, 0u) << result.max_distance;
  const StylePtr other = style_of("grammar other: facade {\n axiom A\n A -> window\n}\n");
  EXPECT_THROW(tree_to_edits(FacadeState(other, state.canvas()), state.tree()), Error);
}

/// "line:column: message (hint)"
std::string fault(const std::string& text) {
  try {
    tree_to_edits(blank(), read_tree(text, "tree.json"));
  } catch (const Error& error) {
    return std::to_string(error.where().line) + ":" + std::to_string(error.where().column) + ": " +
           error.what() + (error.hint().empty() ? "" : " (" + error.hint() + ")");
  }
  return "";
}

TEST(TreeToEdits, BrokenTreesAreRejected) {
  const std::string good =
      facade::tree_json(after(blank(), {"act 0 Grid columns=2 rows=2"}).tree());
  EXPECT_EQ(fault(good), "");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return fault(text);
  };
  EXPECT_EQ(fault("{}").substr(0, 34), "1:1: this is not a facade tree (us");
  EXPECT_NE(fault(good.substr(0, good.size() / 2)).find("invalid JSON"), std::string::npos);
  EXPECT_NE(changed("\"parent\": -1", "\"parent\": 3")
                .find("/nodes/0/parent: node 0 has an invalid parent"),
            std::string::npos);
  EXPECT_NE(
      changed("\"element\": \"window\"", "\"element\": \"windoe\"").find("did you mean 'window'"),
      std::string::npos);
  EXPECT_NE(changed("12.0,", "\"a\",").find("expected a number"), std::string::npos);
  EXPECT_NE(changed("Facade -> Grid", "Facade -> Grit").find("the grammar 'ripperda' has no rule"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::modeller
