// SPDX-License-Identifier: Apache-2.0
// Column alignment of the lines of a formatted text.
#pragma once

#include <string>
#include <vector>

namespace vug::scene {

/// One line. The cells of adjacent lines of the same kind and indent are aligned.
struct FormattedLine {
  bool blank_before = false;
  int indent = 0;
  std::string kind;                ///< Empty: not aligned.
  std::vector<std::string> cells;  ///< The first is not empty unless the line is a comment.
  std::string comment;             ///< With its '#', or empty.
};

/// Minimum number of spaces before cell `cell` of a line of this kind.
int cell_gap(const std::string& kind, size_t cell);

/// The aligned lines as text.
std::string align_columns(const std::vector<FormattedLine>& rows);

}  // namespace vug::scene
