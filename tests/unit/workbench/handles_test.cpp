// SPDX-License-Identifier: Apache-2.0
// Handles of mirrored and repeated nodes.
#include "bench.h"

#include <vug/workbench/handles.h>
#include <vug/workbench/specification.h>

namespace vug::workbench {
namespace {

/// The session of the data with the grid of the mirrored side selected.
struct SideGrid : testing::Test {
  SideGrid() {
    bench.open(paris_session());
    run_command(bench, "select 0.1.0.0");
    node = bench.selected();
  }
  std::vector<double> lefts() const {
    std::vector<double> out;
    for (const facade::Rect& each : instances(bench.state(), bench.state().find("0.1.0.0.0")))
      out.push_back(each.x);
    std::sort(out.begin(), out.end());
    return out;
  }
  FacadeBench bench;
  int node = 0;
};

TEST_F(SideGrid, HasAllHandlesInBothInstances) {
  const std::vector<Handle> all = handles(bench.state(), node);
  // Two columns, five rows, and the two edges of the lowest left window.
  EXPECT_EQ(all.size(), 2u * 9u);
  for (const Handle& each : all) {
    const facade::Rect side = instances(bench.state(), node).at(each.instance);
    EXPECT_GE(each.x0, side.x - 1e-9);
    EXPECT_LE(each.x1, side.right() + 1e-9);
    EXPECT_LE(each.y1, side.top() + 1e-9);
  }
}

TEST_F(SideGrid, ADragOnTheRightMovesTheLeftByTheSameDistance) {
  const std::vector<double> before = lefts();
  const Handle* right = nullptr;
  const std::vector<Handle> all = handles(bench.state(), node);
  for (const Handle& each : all)
    if (each.instance == 1 && each.index == 1) right = &each;
  ASSERT_TRUE(right && right->upright);
  // 20 cm to the right on the plane; the mirrored instance runs from right to left.
  const double to = own_position(bench.state(), node, *right, right->x0 + 0.2, 8);
  EXPECT_NEAR(to, right->at - 0.2, 1e-9);
  bench.edit(drag_edit(bench.state(), node, *right, to));
  const std::vector<double> after = lefts();
  double moved_left = 0, moved_right = 0;
  for (size_t i = 0; i < after.size(); ++i) {
    if (after[i] < before[i] - 1e-9) moved_left = before[i] - after[i];
    if (after[i] > before[i] + 1e-9) moved_right = after[i] - before[i];
  }
  EXPECT_NEAR(moved_left, 0.2, 1e-9);
  EXPECT_NEAR(moved_right, 0.2, 1e-9);
}

TEST_F(SideGrid, EdgesSetTheSizeOfWindows) {
  for (const Handle& each : handles(bench.state(), node)) {
    if (each.line) continue;
    const modeller::FacadeState wider =
        modeller::perform_edit(bench.state(), drag_edit(bench.state(), node, each, each.at + 0.1));
    const Specification form = specification(wider, wider.find("0.1.0.0"));
    EXPECT_NEAR(find_field(form, each.number).value, (each.upright ? 1.4 : 2) + 0.1, 1e-9);
  }
}

TEST_F(SideGrid, TheNearestHandleIsFound) {
  const std::vector<Handle> all = handles(bench.state(), node);
  for (const Handle& each : all) {
    const auto found = handle_at(all, (each.x0 + each.x1) / 2, (each.y0 + each.y1) / 2, 0.01);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->upright, each.upright);
  }
  EXPECT_FALSE(handle_at(all, -5, -5, 0.1));
}

TEST_F(SideGrid, NumbersOfWindowsAreThoseOfTheirGrid) {
  const modeller::FacadeState& state = bench.state();
  EXPECT_EQ(numbers_node(state, state.find("0.1.0.0.0")), node) << "an element has none";
  EXPECT_EQ(numbers_node(state, state.find("0.1.0")), node) << "a rule that passes its area on";
  EXPECT_EQ(numbers_node(state, state.find("0.0.0")), state.find("0.0"));
}

TEST_F(SideGrid, FieldsChangeOneValueOnly) {
  const Specification form = specification(bench.state(), node);
  const modeller::Edit edit = field_edit(bench.state(), form, find_field(form, "dy 2"), 3.3);
  EXPECT_EQ(to_string(edit), "set 0.1.0.0 dy=3.5,3.3,2.6,3.6");
  EXPECT_THROW(find_field(form, "dz"), Error);
  const modeller::FacadeState& state = bench.state();
  const Specification rows = specification(state, state.find("0.0"));
  const modeller::FacadeState wide =
      modeller::perform_edit(state, field_edit(state, rows, find_field(rows, "widths 3"), 6));
  const Specification after = specification(wide, wide.find("0.0"));
  EXPECT_NEAR(find_field(after, "widths 3").value, 6, 1e-9);
  EXPECT_NEAR(find_field(after, "widths 2").value, 2.8, 1e-9) << "the neighbour makes room";
}

TEST_F(SideGrid, RulesOfANodeCanBeChosenInTheForm) {
  const modeller::FacadeState& state = bench.state();
  const std::vector<RuleField> mirror = rule_fields(state, state.find("0.1"));
  ASSERT_EQ(mirror.size(), 1u);
  EXPECT_EQ(mirror[0].rules.at(static_cast<size_t>(mirror[0].current)),
            "mirror(SymmetricFacadeSide, SymmetricFacadeMiddle)");
  const std::vector<RuleField> side = rule_fields(state, state.find("0.1.0"));
  ASSERT_EQ(side.size(), 2u) << "the type of the grid, and its content";
  EXPECT_EQ(side[1].node, node);
  EXPECT_EQ(to_string(rule_edit(state, side[1], 1)), "change 0.1.0.0 grid(window, door)");
  EXPECT_EQ(rule_fields(state, state.find("0.0.0.0"))[0].node, state.find("0.0.0"))
      << "the rule of an element is that of its parent";
  for (const RuleField& each : rule_fields(state, state.find("0.0.0")))
    for (size_t rule = 0; rule < each.rules.size(); ++rule)
      if (static_cast<int>(rule) != each.current) {
        EXPECT_NO_THROW(modeller::perform_edit(state, rule_edit(state, each, rule)));
      }
}

}  // namespace
}  // namespace vug::workbench
