// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <vug/modeller/lines.h>

#include <cmath>

namespace vug::modeller {
namespace {

TEST(Edit, FigureTwoOfThePaper) {
  // A symmetric facade with different windows on the sides and equal ones with a door in the
  // middle.
  const FacadeState state = after(
      blank(10, 12), {"apply 0 mirror(SymmetricFacadeSide, SymmetricFacadeMiddle) width=3m",
                      "act 0.0 RegularGrid columns=1 rows=4 x=1 width=1.5 y=1 height=1.5 dy=2.75",
                      "act 0.1 RegularIdenticalGrid columns=1 rows=4 door=0"});
  EXPECT_TRUE(state.open().empty());
  EXPECT_EQ(rects(state).size(), 11u);
  EXPECT_EQ(rects(state, "door").size(), 1u);
  const std::string theta = facade::theta(state.tree());
  EXPECT_EQ(theta.find("Facade(0, 0, 10, 12, (SymmetricFacadeSide(RegularGrid(1, 4, 1, 1, 0, 2.75"),
            0u)
      << theta;
}

TEST(Edit, EveryRuleOfThePaperCanBeApplied) {
  // Edits from the facade to each symbol.
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {"0", {}},
      {"0.0", {"apply 0 rows"}},
      {"0.1", {"apply 0 rows"}},
      {"0.0", {"apply 0 repeat"}},
      {"0.0", {"apply 0 mirror(SymmetricFacadeSide)"}},
      {"0.1", {"apply 0 mirror(SymmetricFacadeSide, SymmetricFacadeMiddle)"}},
      {"0.0", {"apply 0 Grid"}},
      {"0.0", {"apply 0 RegularGrid"}},
      {"0.0", {"apply 0 IdenticalGrid"}},
      {"0.0", {"apply 0 RegularIdenticalGrid"}},
      {"0.0.1", {"apply 0 rows", "apply 0.0 repeat(FacadeElement)"}}};
  int applied = 0;
  for (const auto& [node, edits] : cases) {
    const FacadeState state = after(blank(), edits);
    const Style& style = state.style();
    for (const int rule : style.rules_of(state.node(state.find(node)).symbol)) {
      const FacadeState done = perform_edit(state, {"apply", node, style.rule_name(rule), {}});
      EXPECT_EQ(done.rule(done.find(node)), rule);
      // Retracting restores the previous bytes.
      EXPECT_EQ(bytes(perform_edit(done, {"retract", node, "", {}})), bytes(state));
      ++applied;
    }
  }
  EXPECT_EQ(applied, 45);
}

TEST(Edit, RejectionsNameTheFaultAndTheReason) {
  const FacadeState state =
      after(blank(), {"apply 0 rows heights=3", "act 0.1 Grid columns=3 rows=2"});
  EXPECT_EQ(refusal(state, "apply 0 Grid"),
            "rule: 'Facade' at 0 is already divided, by rows(FacadeRow, PartFacade) (retract or "
            "change that rule)");
  EXPECT_EQ(refusal(state, "apply 0.0 IdenticalGrd"),
            "rule: 'FacadeRow' has no rule 'IdenticalGrd' (did you mean 'IdenticalGrid'?)");
  EXPECT_EQ(refusal(state, "apply 0.1.0.0 Grid").substr(0, 32), "rule: 'window' at 0.1.0.0 is an ");
  EXPECT_EQ(refusal(state, "apply 0.7 Grid").substr(0, 6), "node: ");
  EXPECT_EQ(refusal(state, "set 0.1.0 columns=0"),
            "numbers/columns: 'columns' is 0, while dividing Grid 12 x 6 m at (0, 3) (it must be "
            "1 to 1000 here)");
  EXPECT_EQ(refusal(state, "set 0.1.0 row=3").substr(0, 13), "numbers/row: ");
  EXPECT_NE(refusal(state, "set 0.1.0 row=3").find("did you mean 'rows'?"), std::string::npos);
  EXPECT_NE(refusal(state, "set 0.1.0 width=5"), "");
  EXPECT_NE(refusal(state, "set 0 heights=8.99").find("the minimum is"), std::string::npos);
  EXPECT_NE(refusal(state, "retract 0.0"), "");
  EXPECT_NE(refusal(state, "retract 0.0 x=1"), "");
  EXPECT_NE(refusal(state, "toggle 0.1.0 column=3 row=0").find("counted from 0"),
            std::string::npos);
  EXPECT_NE(refusal(state, "toggle 0.1.0 column=1"), "");
  EXPECT_NE(refusal(state, "move 0 line=1 to=3").find("numbers/line"), std::string::npos);
  EXPECT_NE(refusal(state, "move 0 line=0 to=9"), "");
  EXPECT_NE(refusal(state, "separate 0"), "");
  EXPECT_NE(refusal(state, "join 0"), "");
  EXPECT_NE(refusal(state, "change 0.1 Grid"), "");
  EXPECT_NE(refusal(state, "change 0.1.0.0 Grid"), "");
  EXPECT_THROW(parse_edit("applyy 0 rows"), Error);
  EXPECT_THROW(parse_edit(""), Error);
  EXPECT_THROW(parse_edit("apply"), Error);
  EXPECT_THROW(parse_edit("set 0 x=nan"), Error);
  EXPECT_THROW(parse_edit("set 0 x=1e999"), Error);
  EXPECT_THROW(parse_edit("set 0 x=3furlong"), Error);
  EXPECT_THROW(parse_edit("set 0 x=3px"), Error);
  EXPECT_THROW(parse_edit("set 0 x=3 x=4"), Error);
  EXPECT_THROW(parse_edit("set 0 rows x=3"), Error);
}

TEST(Edit, TextRoundTrip) {
  for (const char* text :
       {"apply 0 rows(FacadeRow, PartFacade) heights=3.2", "retract 0.1", "set 0.0 dx=2.1,2.4 x=1",
        "toggle Facade.Grid column=2 row=0", "set 0 dx="})
    EXPECT_EQ(to_string(parse_edit(text)), text);
  const Edit units = parse_edit("0 heights=320cm,120px", "set", 0.02);
  EXPECT_EQ(units.numbers.at("heights"), (std::vector<double>{3.2, 2.4}));
}

TEST(Edit, LinesMove) {
  FacadeState state = after(blank(), {"apply 0 rows heights=3", "move 0 line=0 to=4.5"});
  EXPECT_EQ(state.node(state.find("0.1")).rect.y, 4.5);
  state = after(blank(), {"apply 0 mirror(SymmetricFacadeSide, SymmetricFacadeMiddle) width=4"});
  EXPECT_EQ(lines(state, 0).size(), 2u);
  for (const char* edit : {"move 0 line=0 to=3", "move 0 line=1 to=9"})
    EXPECT_NEAR(after(state, {edit}).node(2).rect.width, 6, 1e-12);
  // Uneven elements of a ground floor.
  state = after(
      blank(), {"apply 0 rows", "apply 0.0 repeat(FacadeElement) count=4", "move 0.0 line=1 to=7"});
  EXPECT_NEAR(state.node(state.find("0.0.1")).rect.right(), 7, 1e-12);
  EXPECT_NEAR(state.node(state.find("0.0.0")).rect.right(), 3, 1e-12);
  EXPECT_NEAR(state.node(state.find("0.0.2")).rect.right(), 9, 1e-12);
}

TEST(Edit, LinesOfGrids) {
  const std::string numbers = " columns=3 rows=1 x=1 width=1 dx=3";
  const auto xs = [](const FacadeState& state) {
    std::vector<double> out;
    for (const facade::Rect& rect : rects(state)) out.push_back(std::round(rect.x * 1e9) / 1e9);
    return out;
  };
  using V = std::vector<double>;
  const FacadeState regular = after(blank(), {"act 0 RegularGrid" + numbers});
  EXPECT_EQ(lines(regular, 1).size(), 4u) << "three columns and a row";
  EXPECT_EQ(xs(regular), (V{1, 4, 7}));
  EXPECT_EQ(xs(after(regular, {"move 0.0 line=0 to=2"})), (V{2, 5, 8})) << "all along";
  EXPECT_EQ(xs(after(regular, {"move 0.0 line=2 to=9"})), (V{1, 5, 9})) << "all distances";
  const FacadeState grid = after(blank(), {"act 0 Grid" + numbers});
  EXPECT_EQ(xs(grid), (V{1, 4, 7}));
  EXPECT_EQ(xs(after(grid, {"move 0.0 line=0 to=2"})), (V{2, 4, 7})) << "by itself";
  EXPECT_EQ(xs(after(grid, {"move 0.0 line=1 to=5"})), (V{1, 5, 7}));
  EXPECT_EQ(xs(after(grid, {"move 0.0 line=2 to=10"})), (V{1, 4, 10}));
  EXPECT_NE(refusal(grid, "move 0.0 line=1 to=6.5"), "") << "windows would overlap";
  EXPECT_NEAR(rects(after(grid, {"move 0.0 line=3 to=2"}))[0].y, 2, 1e-12);
}

TEST(Edit, GridTypesChangeAndKeepTheirNumbers) {
  const FacadeState grid =
      after(blank(), {"act 0 Grid columns=3 rows=2 x=1 width=1 dx=3,4 y=1 height=1.5 dy=4"});
  EXPECT_EQ(rects(grid)[4].x, 8);
  const FacadeState regular = after(grid, {"change 0 RegularGrid"});
  EXPECT_EQ(regular.node(1).symbol, "RegularGrid");
  EXPECT_EQ(rects(regular).size(), 6u);
  EXPECT_EQ(rects(regular)[4].x, 8) << "the mean of both spacings";
  EXPECT_EQ(rects(regular)[2].x, 4.5);
  const FacadeState identical = after(regular, {"change 0 RegularIdenticalGrid"});
  EXPECT_EQ(identical.tree().nodes.size(), 3u) << "one window for all";
  EXPECT_EQ(rects(identical), rects(regular));
  const FacadeState back = after(identical, {"change 0 Grid"});
  EXPECT_EQ(rects(back), rects(regular));
  // With a door, and without one again.
  const FacadeState door = after(back, {"change 0.0 grid(window, door) door=1"});
  EXPECT_EQ(rects(door).size(), 5u);
  EXPECT_EQ(rects(door, "door")[0].x, 4.5);
  EXPECT_EQ(bytes(after(door, {"change 0.0 grid(window)"})), bytes(back));
  // Numbers given with the change are kept.
  EXPECT_EQ(refusal(grid, "change 0 RegularGrid dx=1,2").substr(0, 11), "numbers/dx:");
}

TEST(Edit, ChangedCountsResetTheirSpacings) {
  const FacadeState grid = after(blank(), {"act 0 Grid columns=3 rows=1 x=1 width=1 dx=3,4"});
  const FacadeState four = after(grid, {"set 0.0 columns=4"});
  ASSERT_EQ(rects(four).size(), 4u);
  EXPECT_EQ(rects(four)[0].x, 1);
  EXPECT_NEAR(rects(four)[3].x, 10, 1e-9) << "equal margins";
  const FacadeState told = after(grid, {"set 0.0 columns=4 dx=2,3,2"});
  EXPECT_EQ(rects(told)[3].x, 8);
  EXPECT_EQ(rects(after(told, {"set 0.0 dx="})).size(), 4u);
  EXPECT_EQ(bytes(after(told, {"set 0.0 dx="})), bytes(four));
}

TEST(Edit, CellsOfAGrid) {
  const FacadeState grid = after(blank(), {"act 0 Grid columns=3 rows=2"});
  const FacadeState off = after(grid, {"toggle 0.0 column=1 row=0"});
  EXPECT_EQ(rects(off).size(), 5u);
  EXPECT_EQ(off.node(off.find("0.0.window[1,1]")).rect,
            grid.node(grid.find("0.0.window[1,1]")).rect);
  EXPECT_EQ(bytes(after(off, {"toggle 0.0 column=1 row=0"})), bytes(grid));
  // Cells stay off under another count and come back unchanged.
  const FacadeState fewer = after(off, {"set 0.0 columns=1", "set 0.0 columns=3"});
  EXPECT_EQ(bytes(fewer), bytes(off));
  const FacadeState alike = after(blank(), {"act 0 RegularIdenticalGrid columns=3 rows=2"});
  EXPECT_NE(refusal(alike, "toggle 0.0 column=1 row=0").find("separate its cells"),
            std::string::npos);
  EXPECT_EQ(rects(after(alike, {"separate 0.0", "toggle 0.0 column=1 row=0"})).size(), 5u);
  const FacadeState one =
      after(blank(), {"act 0 Grid columns=2 rows=1", "toggle 0.0 column=0 row=0"});
  EXPECT_NE(refusal(one, "toggle 0.0 column=1 row=0").find("last cell"), std::string::npos);
}

TEST(Edit, EditsOfASideAffectItsMirrorImage) {
  const FacadeState side = after(blank(), {"apply 0 mirror(SymmetricFacadeSide)",
                                           "act 0.0 Grid columns=2 rows=1 x=1 width=1 dx=3"});
  const auto mirrored = [](const FacadeState& state) {
    const std::vector<facade::Rect> all = rects(state);
    for (const facade::Rect& one : all)
      if (std::none_of(all.begin(), all.end(), [&](const facade::Rect& other) {
            return std::abs(other.x - (12 - one.right())) < 1e-9 && other.y == one.y;
          }))
        return false;
    return !all.empty();
  };
  EXPECT_TRUE(mirrored(side));
  for (const char* edit : {"move 0.0.0 line=0 to=0.3", "set 0.0.0 width=1.4", "set 0.0.0 columns=3",
                           "toggle 0.0.0 column=0 row=0", "change 0.0.0 grid(window, door) door=0"})
    EXPECT_TRUE(mirrored(after(side, {edit}))) << edit;
  // After separation everything keeps its position; then each side is independent.
  const FacadeState broken = after(side, {"separate 0"});
  const std::vector<facade::Rect> was = rects(side), is = rects(broken);
  ASSERT_EQ(is.size(), was.size());
  for (size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i].x, was[i].x, 1e-12);
  EXPECT_FALSE(mirrored(after(broken, {"toggle 0.0.0 column=0 row=0"})));
  EXPECT_EQ(rects(after(broken, {"toggle 0.0.0 column=0 row=0"})).size(), 3u);
  // In the mirror image lines run from the right: the same move there preserves the symmetry.
  EXPECT_TRUE(mirrored(after(broken, {"move 0.0.0 line=0 to=0.3", "move 0.1.0 line=0 to=0.3"})));
  const FacadeState joined = after(broken, {"toggle 0.1.0 column=0 row=0", "join 0"});
  EXPECT_EQ(bytes(joined), bytes(side));
}

TEST(Edit, RepeatedPartsAreSeparatedWithTheirDescendants) {
  const FacadeState bays =
      after(blank(), {"apply 0 repeat count=3", "apply 0.0 mirror(SymmetricFacadeSide)",
                      "act 0.0.0 RegularIdenticalGrid columns=1 rows=3"});
  EXPECT_EQ(rects(bays).size(), 18u);
  EXPECT_EQ(bays.tree().nodes.size(), 5u);
  const FacadeState apart = after(bays, {"separate 0"});
  EXPECT_EQ(apart.parts(0).size(), 3u);
  const std::vector<facade::Rect> was = rects(bays), is = rects(apart);
  ASSERT_EQ(is.size(), was.size());
  for (size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i].x, was[i].x, 1e-9);
  EXPECT_EQ(rects(after(apart, {"retract 0.1"})).size(), 12u);
  EXPECT_EQ(rects(after(apart, {"retract 0.1", "join 0"})), was);
}

TEST(Edit, AnyGrammarOfKindFacade) {
  const StylePtr style = style_of(
      "param STOREYS = 3\nlet pane = 40cm\n"
      "grammar f: facade {\n width 3m * STOREYS\n axiom rows(4m, Base, 1, Rest)\n"
      "Base if width > 8m -> columns(Gate, 2m, door, Gate)\n"
      "Base if width <= 8m -> shop\n"
      "Rest -> repeat(y, Storey(index), count: STOREYS, alike: false)\n"
      "Storey(n) if n == 0 -> rows(1, wall, 2, columns(window, window))\n"
      "Storey(n) if n > 0 -> grid(window, columns: 3, rows: 1, gap: pane)\n"
      "Gate -> inset(pane, window)\n}\n");
  EXPECT_EQ(style->usual_width(), 9);
  EXPECT_FALSE(style->usual_height());
  const FacadeState start(style, {.width = 9, .height = 12});
  EXPECT_EQ(start.tree().nodes.size(), 2u) << "the axiom's split is not a choice";
  EXPECT_EQ(refusal(start, "apply 0 shop").substr(0, 45),
            "rule: the condition of 'Base -> shop' is fals");
  const FacadeState done = after(start, {"apply 0 columns", "apply 0.0 inset", "apply 0.2 inset",
                                         "apply 1 repeat", "apply 1.0 rows", "apply 1.1 grid"});
  EXPECT_EQ(done.open().size(), 1u);
  EXPECT_NE(refusal(done, "apply 1.2 rows"), "");
  // The nested split has free numbers of its own.
  const int inner = done.find("1.0.1");
  EXPECT_EQ(done.node(inner).symbol, "columns");
  const FacadeState moved = after(done, {"move 1.0.1 line=0 to=2"});
  EXPECT_EQ(moved.node(moved.find("1.0.1.1")).rect.x, 2);
  EXPECT_EQ(bytes(after(moved, {"retract 1.0.1"})), bytes(done));
  EXPECT_NE(refusal(done, "apply 1.0.1 columns"), "");
  EXPECT_NE(refusal(done, "set 0 widths=3").find("the rule specifies all sizes"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::modeller
