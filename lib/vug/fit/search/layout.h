// SPDX-License-Identifier: Apache-2.0
// Columns and rows of windows in an area by alternating dynamic programming, and the resulting
// grids.
#pragma once

#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/move.h>
#include <vug/fit/search/segments.h>

namespace vug::fit {

/// In coordinates of the area.
struct Layout {
  std::vector<Segment> columns, rows;
  bool empty() const { return columns.empty() || rows.empty(); }
  bool operator==(const Layout&) const = default;
};

/// Alternates `turns` times between the best columns for the rows and the best rows for the
/// columns. Starts with columns over the whole area, or with rows if `rows_first`.
Layout find_layout(const FoldedIntegral& integral, const Limits& limits, double cost, int turns,
                   bool rows_first);

/// Candidates for node i as a grid of that layout with its windows: for each grid type of the
/// rules, with one or several window sizes, with and without a door. All candidates have a finite
/// energy. The door is at `door`, or below one of the columns if that is empty.
std::vector<TreeState> grid_candidates(const MoveContext& context, const TreeState& state, int i,
                                       const FoldedIntegral& integral, const Layout& layout,
                                       const Rect& door);

}  // namespace vug::fit
