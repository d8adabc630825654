// Columns and rows of windows in an area, found by dynamic programming in turn, and grids of them.
#pragma once

#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/move.h>
#include <vug/fit/search/segments.h>

namespace vug::fit {

/// In the area's own coordinates.
struct Layout {
  std::vector<Segment> columns, rows;
  bool empty() const { return columns.empty() || rows.empty(); }
  bool operator==(const Layout&) const = default;
};

/// The columns that gain most given the rows, then the rows given the columns, in that many turns;
/// at first of all of the area, or so the rows where `rows_first` says so.
Layout find_layout(const FoldedIntegral& integral, const Limits& limits, double cost, int turns,
                   bool rows_first);

/// Node i rewritten into a grid of that layout and its windows: of each type that the rules have,
/// with windows of one size or of several, with a door and without; each has a finite energy. The
/// door stands in `door`, unless that is empty, or below some column.
std::vector<TreeState> grid_candidates(const MoveContext& context, const TreeState& state, int i,
                                       const FoldedIntegral& integral, const Layout& layout,
                                       const Rect& door);

}  // namespace vug::fit
