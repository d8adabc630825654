// Lines of a formatted text whose parts stand in columns.
#pragma once

#include <string>
#include <vector>

namespace vug::scene {

/// One line. Neighbours of the same kind and indent form a run whose cells line up.
struct FormattedLine {
  bool blank_before = false;
  int indent = 0;
  std::string kind;                ///< Empty: lines up with nothing.
  std::vector<std::string> cells;  ///< The first is never empty unless the line is a comment.
  std::string comment;             ///< With its '#', or empty.
};

/// Spaces before cell `cell` of a row of this kind when nothing lines up.
int cell_gap(const std::string& kind, size_t cell);

/// All rows as text.
std::string align_columns(const std::vector<FormattedLine>& rows);

}  // namespace vug::scene
