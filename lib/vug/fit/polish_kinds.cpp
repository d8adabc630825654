// Kinds of a grid's windows: for each number of kinds the sizes that gain most, and what stands in
// each cell. Bits of cells grow only where the kinds pass a power of two, so that chains, which
// walk by single steps, are held back by what costs nothing further on.
#include <vug/fit/cells.h>
#include <vug/fit/polish.h>
#include <vug/fit/sheet.h>
#include <vug/fit/sizes.h>

#include <algorithm>

namespace vug::fit {
namespace {

/// How far windows of each line may reach: to the next line, or to the border.
std::vector<int> rooms(const Lines& lines, int count, int border) {
  std::vector<int> out;
  for (int line = 0; line < count; ++line) {
    const auto at = static_cast<size_t>(line);
    out.push_back((line + 1 < count ? lines[at + 1] - 1 : border) - lines[at]);
  }
  return out;
}

/// Of the grid's cells, row after row from the top.
SizeGains size_gains(const Sheet& sheet, const Node& grid, const Area& area, const Rect& door,
                     int least) {
  const std::vector<int> across = rooms(grid.left, grid.columns, columns_room(area));
  const std::vector<int> down = rooms(grid.top, grid.rows, area.height);
  SizeGains out;
  out.least = {least, least};
  out.most = {*std::max_element(across.begin(), across.end()),
              *std::max_element(down.begin(), down.end())};
  for (size_t row = 0; row < down.size(); ++row)
    for (size_t column = 0; column < across.size(); ++column) {
      std::vector<double>& cell = out.cells.emplace_back(out.count(), 0.0);
      const int x = grid.left[column], y = grid.top[row];
      size_t at = 0;
      for (int height = least; height <= out.most.height; ++height)
        for (int width = least; width <= out.most.width; ++width, ++at) {
          if (width > across[column] || height > down[row]) continue;
          const Rect rect{x, y, x + width, y + height};
          if (!overlap(rect, door)) cell[at] = sheet.sum(rect.x0, rect.y0, rect.x1, rect.y1);
        }
    }
  return out;
}

}  // namespace

bool polish_kinds(const Workshop& shop, const Evidence& evidence, State& state, int i) {
  const Model& model = shop.model;
  const int grid = i + 1;
  if (!has_cells(shop, state, grid) || !model.likelihood()) return false;
  bool any = false;
  for (bool better = true; better;) {
    better = false;
    const Sheet sheet(GainMap(evidence, gains_in(model, evidence, state, i)), state, state.area(i));
    const Node& last = state.tree[state.tree.end(grid) - 1];
    const Rect door = model.in_grid(last) ? Rect{} : rect_of(last);
    const SizeGains gains =
        size_gains(sheet, state.tree[grid], state.area(i), door, model.limits().least);
    // A kind costs its node; that cells may take more bits too is for the model to tell.
    const double cost = model.complexity(state.tree, grid + 1) / model.trust();
    State best = state;
    for (const SizeChoice& choice : choose_sizes(gains, model.limits().most_kinds, cost))
      better |= take_cheaper(model, best, with_windows(model, state, grid, choice));
    if (better) state = std::move(best), any = true;
  }
  return any;
}

}  // namespace vug::fit
