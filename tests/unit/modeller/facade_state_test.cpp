// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <vug/modeller/history.h>

namespace vug::modeller {
namespace {

TEST(FacadeState, StartsWithTheAxiomOnly) {
  const FacadeState state = blank();
  ASSERT_EQ(state.tree().nodes.size(), 1u);
  EXPECT_TRUE(state.node(0).stuck);
  EXPECT_EQ(state.open(), std::vector<int>{0});
  EXPECT_EQ(facade::theta(state.tree()), "Facade(0, 0, 12, 9)");
  EXPECT_THROW(blank(0), Error);
  EXPECT_THROW(blank(std::nan("")), Error);
  EXPECT_THROW(blank(1e300), Error);
}

TEST(FacadeState, PathsInNumbersAndNames) {
  const FacadeState state =
      after(blank(), {"apply 0 rows heights=3", "act 0.1 RegularGrid columns=3 rows=2",
                      "apply 0.0 repeat count=3"});
  for (size_t i = 0; i < state.tree().nodes.size(); ++i) {
    const int index = static_cast<int>(i);
    EXPECT_EQ(state.find(state.path(index)), index);
    EXPECT_EQ(state.at(state.path_keys(index)), index);
  }
  const int grid = state.find("0.1.0");
  EXPECT_EQ(state.node(grid).symbol, "RegularGrid");
  EXPECT_EQ(state.find("Facade.PartFacade.RegularGrid"), grid);
  EXPECT_EQ(state.find("0.PartFacade.0.window[2,1]"), state.find("0.1.0.5"));
  EXPECT_EQ(state.find("Facade.FacadeRow.FacadeElement[2]"), state.find("0.0.2"));
  EXPECT_EQ(state.find("."), FacadeState::kWhole);
  const auto message = [&](const std::string& path) -> std::string {
    try {
      state.find(path);
    } catch (const Error& error) {
      return std::string(error.what()) + " (" + error.hint() + ")";
    }
    return "";
  };
  EXPECT_EQ(message("0.2"), "'Facade' at 0 has no part '2' (it has 2 of them, counted from 0)");
  EXPECT_EQ(message("0.PartFacad"),
            "'Facade' at 0 has no part 'PartFacad' (did you mean 'PartFacade'?)");
  EXPECT_EQ(message("0.0.0.0"),
            "'FacadeElement' at 0.0.0 has no part '0' (no rule divides it yet)");
  EXPECT_EQ(message("0.1.0.0.0"), "'window' at 0.1.0.0 has no part '0' (it is an element)");
  for (const char* broken : {"", "..", "0.", "[", "a[", "0[1", "x[1,2,3]", "0.1.0.window[9,9]",
                             "99999999999", "-1", "0.window[,]"})
    EXPECT_NE(message(broken), "") << broken;
}

TEST(FacadeState, RulesByName) {
  const Style& style = *ripperda();
  EXPECT_EQ(style.rules().rules.size(), 45u);
  for (size_t i = 0; i < 45; ++i) {
    const int rule = static_cast<int>(i);
    const std::string& head = style.rule(rule).head;
    EXPECT_EQ(style.find_rule(head, style.rule_name(rule)), rule);
    EXPECT_EQ(style.find_rule(head, head + " -> " + style.rule_name(rule)), rule);
  }
  EXPECT_EQ(style.rule_name(style.find_rule("Facade", "rows")), "rows(FacadeRow, PartFacade)");
  EXPECT_THROW(style.find_rule("Facade", "mirror"), Error) << "ambiguous first word";
  EXPECT_THROW(style.find_rule("Facade", ""), Error);
  const StylePtr twins = style_of(
      "grammar f: facade {\n axiom A\n A if height > 3m -> window\n A if height <= 3m -> "
      "window\n}\n");
  EXPECT_EQ(twins->rule_name(1), "window #2");
  EXPECT_EQ(twins->find_rule("A", "window #2"), 1);
  EXPECT_EQ(twins->find_rule("A", "#1"), 0);
}

TEST(FacadeState, HistoryGoesBothWays) {
  History history(blank());
  const std::string first = bytes(history.current());
  history.apply(parse_edit("apply 0 rows heights=3"));
  history.set_checkpoint("rows");
  const std::string second = bytes(history.current());
  history.apply(parse_edit("act 0.1 Grid"));
  history.set_checkpoint("grid");
  const std::string third = bytes(history.current());
  EXPECT_EQ(history.undo(5), 2u);
  EXPECT_EQ(bytes(history.current()), first);
  EXPECT_EQ(history.redo(), 1u);
  EXPECT_EQ(bytes(history.current()), second);
  history.restore("grid");
  EXPECT_EQ(bytes(history.current()), third);
  history.restore("rows");
  // A rejected edit changes nothing, including the edits that can be redone.
  EXPECT_THROW(history.apply(parse_edit("apply 0.1 Gridd")), RejectedEdit);
  EXPECT_EQ(bytes(history.current()), second);
  EXPECT_EQ(history.redo(), 1u);
  history.undo();
  history.apply(parse_edit("act 0.1 IdenticalGrid"));
  EXPECT_EQ(history.redo(), 0u);
  EXPECT_EQ(history.edits().size(), 2u);
  EXPECT_EQ(history.checkpoints().size(), 1u) << "discarded edits remove their checkpoints";
  EXPECT_THROW(history.restore("grid"), Error);
  EXPECT_THROW(history.set_checkpoint(""), Error);
}

}  // namespace
}  // namespace vug::modeller
