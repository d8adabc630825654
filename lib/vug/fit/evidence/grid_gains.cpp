// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/evidence/grid_gains.h>

namespace vug::fit {

GridGains::GridGains(const Model& model, const Evidence& evidence, const TreeState& state, int grid)
    : area_(state.area(grid)),
      integral_(GainMap(evidence, gains_from_grid(model, evidence, state, grid - 1)), state,
                area_) {
  const Node& last = state.tree[state.tree.end(grid) - 1];
  if (!model.in_grid(last)) door_ = rect_of(last);
}

WindowSize GridGains::max_size(const Node& grid, int column, int row) const {
  const auto c = static_cast<size_t>(column), r = static_cast<size_t>(row);
  const int right = column + 1 < grid.columns ? grid.left[c + 1] - 1 : room(true);
  const int bottom = row + 1 < grid.rows ? grid.top[r + 1] - 1 : room(false);
  return {right - grid.left[c], bottom - grid.top[r]};
}

double GridGains::gain(const Node& grid, int column, int row, const WindowSize& size) const {
  const WindowSize there = max_size(grid, column, row);
  if (size.width > there.width || size.height > there.height) return 0;
  const int x = grid.left[static_cast<size_t>(column)], y = grid.top[static_cast<size_t>(row)];
  const Rect rect{x, y, x + size.width, y + size.height};
  return overlap(rect, door_) ? 0 : integral_.sum(rect.x0, rect.y0, rect.x1, rect.y1);
}

}  // namespace vug::fit
