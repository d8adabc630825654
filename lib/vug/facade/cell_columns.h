// SPDX-License-Identifier: Apache-2.0
// Arrangement of free cells in columns, so that a grammar can state each edge of a column once.
#pragma once

#include <vug/facade/rect.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::facade {

struct RuleCell {
  Rect rect;
  std::string part;  ///< Its text in a rule.
};

/// A strip as wide as the widest of its cells, with the cells from the bottom up.
struct CellColumn {
  double left = 0, right = 0;
  std::vector<RuleCell> cells;
};

/// The narrowest columns, from the left, such that each cell lies in one of them; nothing if two
/// cells of a column overlap vertically.
std::optional<std::vector<CellColumn>> cell_columns(std::vector<RuleCell> cells);

}  // namespace vug::facade
