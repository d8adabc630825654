// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/cell_columns.h>

#include <algorithm>

namespace vug::facade {

namespace {
constexpr double kTouch = 1e-6;  ///< Metres; cells that overlap by less only touch.
}

std::optional<std::vector<CellColumn>> cell_columns(std::vector<RuleCell> cells) {
  std::stable_sort(cells.begin(), cells.end(),
                   [](const RuleCell& a, const RuleCell& b) { return a.rect.x < b.rect.x; });
  std::vector<CellColumn> out;
  for (RuleCell& cell : cells) {
    const double left = cell.rect.x, right = cell.rect.right();
    if (out.empty() || left > out.back().right - kTouch) out.push_back({left, right, {}});
    out.back().right = std::max(out.back().right, right);
    out.back().cells.push_back(std::move(cell));
  }
  for (CellColumn& column : out) {
    std::stable_sort(column.cells.begin(), column.cells.end(),
                     [](const RuleCell& a, const RuleCell& b) { return a.rect.y < b.rect.y; });
    for (size_t i = 1; i < column.cells.size(); ++i)
      if (column.cells[i].rect.y < column.cells[i - 1].rect.top() - kTouch) return std::nullopt;
  }
  return out;
}

}  // namespace vug::facade
