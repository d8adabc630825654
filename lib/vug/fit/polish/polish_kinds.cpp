// SPDX-License-Identifier: Apache-2.0
// Window kinds of a grid: for each number of kinds the sizes with the largest gain, and the kind of
// each cell. The bits of cells grow only when the number of kinds passes a power of two, a barrier
// that chains, which take single steps, rarely cross even if further kinds would be free.
#include <vug/fit/evidence/grid_gains.h>
#include <vug/fit/model/cells.h>
#include <vug/fit/polish/polish.h>

#include <algorithm>

namespace vug::fit {
namespace {

/// Gains of the grid's cells, row by row from the top.
SizeGains size_gains(const GridGains& windows, const Node& grid, int min_size) {
  SizeGains out;
  out.min_size = out.max_size = {min_size, min_size};
  const auto each = [&](const auto& visit) {
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) visit(column, row);
  };
  each([&](int column, int row) {
    const WindowSize most = windows.max_size(grid, column, row);
    out.max_size = {std::max(out.max_size.width, most.width),
                    std::max(out.max_size.height, most.height)};
  });
  each([&](int column, int row) {
    std::vector<double>& cell = out.cells.emplace_back();
    for (size_t at = 0; at < out.count(); ++at)
      cell.push_back(windows.gain(grid, column, row, out.size(at)));
  });
  return out;
}

}  // namespace

bool polish_kinds(const MoveContext& context, const Evidence& evidence, TreeState& state, int i) {
  const Model& model = context.model;
  const int grid = i + 1;
  if (!has_cells(context, state, grid) || !model.likelihood()) return false;
  bool any = false;
  for (bool better = true; better;) {
    better = false;
    const SizeGains gains = size_gains(GridGains(model, evidence, state, grid), state.tree[grid],
                                       model.limits().min_size);
    // A kind costs its node; the model accounts for additional bits of the cells.
    const double cost = model.complexity(state.tree, grid + 1) / model.pixel_weight();
    TreeState best = state;
    for (const SizeChoice& choice : choose_sizes(gains, model.limits().max_kinds, cost))
      better |= replace_if_cheaper(model, best, with_windows(model, state, grid, choice));
    if (better) state = std::move(best), any = true;
  }
  return any;
}

}  // namespace vug::fit
