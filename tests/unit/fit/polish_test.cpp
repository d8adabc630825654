// SPDX-License-Identifier: Apache-2.0
#include "enumeration.h"

#include <vug/fit/polish/polish.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::fit {
namespace {

constexpr int kColumns = 8, kRows = 3, kPitch = 20;
constexpr int kAcross = kColumns * kPitch, kDown = kRows * kPitch;

/// Windows of every other column are wider.
int wide(int column) { return column % 2 == 0 ? 9 : 14; }

Evidence evidence_of_columns() {
  std::vector<uint8_t> clusters(static_cast<size_t>(kAcross * kDown), 0);
  for (int y = 0; y < kDown; ++y)
    for (int x = 0; x < kAcross; ++x)
      if (x % kPitch >= 3 && x % kPitch < 3 + wide(x / kPitch) && y % kPitch >= 4 &&
          y % kPitch < 14)
        clusters[static_cast<size_t>(y * kAcross + x)] = 1;
  return Evidence::from_clusters(kAcross, kDown, 2, clusters);
}

class GridPolish : public testing::Test {
 protected:
  /// A grid whose columns use `kinds` kinds of windows in turn, some a pixel too wide if `off`.
  TreeState with(int kinds, bool off) const {
    Node grid;
    grid.symbol = 1, grid.parent_op = static_cast<int8_t>(Op::grid);
    grid.columns = kColumns, grid.rows = kRows;
    std::vector<Node> windows(static_cast<size_t>(kinds));
    for (int column = 0; column < kColumns; ++column) {
      grid.left[static_cast<size_t>(column)] = static_cast<int16_t>(column * kPitch + 3);
      Node& window = windows[static_cast<size_t>(column % kinds)];
      window.symbol = 2, window.parent_op = static_cast<int8_t>(Op::windows);
      window.width = static_cast<int16_t>(wide(column) + (off && column > 4 ? 1 : 0));
      window.height = 10;
    }
    for (int row = 0; row < kRows; ++row) {
      grid.top[static_cast<size_t>(row)] = static_cast<int16_t>(row * kPitch + 4);
      for (int column = 0; column < kColumns; ++column)
        grid.set_kind(column, row, column % kinds + 1);
    }
    TreeState state = model_.axiom_state();
    state.grow(0, 0, {grid});
    state.grow(1, 1, windows);
    EXPECT_TRUE(std::isfinite(model_.energy(state)));
    return state;
  }

  const Evidence evidence_ = evidence_of_columns();
  const Rules rules_ = rules_of({"Facade grid Grid", "Grid windows Window"});
  const Model model_{
      rules_, {}, kAcross, kDown, {&evidence_, make_likelihood("kt", evidence_), 0.05}};
  const EdgeHints hints_ = EdgeHints::from_clusters(evidence_);
  const MoveContext context_{model_, hints_};
};

/// Each column has its own window kind, some a pixel off, although there are only two sizes; cells
/// take four bits each until only three kinds are left.
TEST_F(GridPolish, KindsAreMergedEvenIfOnlyTheTotalSaves) {
  TreeState best = with(2, false), spoilt = with(8, true);
  EXPECT_TRUE(polish_kinds(context_, evidence_, spoilt, 0));
  EXPECT_NEAR(model_.energy(spoilt), model_.energy(best), 1e-9);
  EXPECT_FALSE(polish_kinds(context_, evidence_, best, 0)) << "already optimal";
}

/// A column of wide windows five pixels too far to the right, where narrow ones gain more: neither
/// its position nor its kinds alone are wrong.
TEST_F(GridPolish, LinesMoveTogetherWithTheKindsOfTheirCells) {
  TreeState best = with(2, false), spoilt = best;
  Node& grid = spoilt.tree[1];
  grid.left[3] = static_cast<int16_t>(grid.left[3] + 5);
  for (int row = 0; row < kRows; ++row) grid.set_kind(3, row, 1);
  spoilt.invalidate_bits(1);
  TreeState moved = spoilt, other_kinds = spoilt;
  moved.tree[1].left[3] = best.tree[1].left[3], moved.invalidate_bits(1);
  for (int row = 0; row < kRows; ++row) other_kinds.tree[1].set_kind(3, row, 2);
  other_kinds.invalidate_bits(1);
  const double bits = model_.energy(spoilt);
  EXPECT_GE(model_.energy(moved), bits - 1e-9);
  EXPECT_GE(model_.energy(other_kinds), bits);
  EXPECT_TRUE(polish_cells(context_, evidence_, spoilt, 0));
  EXPECT_EQ(spoilt.tree, best.tree);
  EXPECT_FALSE(polish_cells(context_, evidence_, best, 0)) << "already optimal";
}

}  // namespace
}  // namespace vug::fit
