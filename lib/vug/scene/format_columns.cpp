// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/scene/format_columns.h>

#include <algorithm>

namespace vug::scene {

namespace {

/// Cells that would move further than this are not aligned.
constexpr size_t kFarthest = 32;

size_t width(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !is_utf8_tail(c); }));
}

void pad_to(std::string& line, size_t column) {
  const size_t now = width(line);
  if (now < column) line.append(column - now, ' ');
}

/// Appends one cell to each line that has it, in a common column unless that is too far.
template <class Part>
void append(std::vector<std::string>& lines, const Part& part, size_t gap) {
  size_t least = std::string::npos, most = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (part(i).empty()) continue;
    const size_t column = width(lines[i]) + gap;
    least = std::min(least, column);
    most = std::max(most, column);
  }
  for (size_t i = 0; i < lines.size(); ++i) {
    if (part(i).empty()) continue;
    pad_to(lines[i], most - least <= kFarthest ? most : width(lines[i]) + gap);
    lines[i] += part(i);
  }
}

void write_run(const std::vector<FormattedLine>& rows, size_t begin, size_t end, std::string& out) {
  const auto indent = static_cast<size_t>(rows[begin].indent);
  std::vector<std::string> lines(end - begin, std::string(indent, ' '));
  size_t cells = 0;
  for (size_t i = begin; i < end; ++i) cells = std::max(cells, rows[i].cells.size());
  static const std::string nothing;
  for (size_t cell = 0; cell < cells; ++cell) {
    const auto part = [&](size_t i) -> const std::string& {
      const FormattedLine& row = rows[begin + i];
      return cell < row.cells.size() ? row.cells[cell] : nothing;
    };
    append(lines, part, cell == 0 ? 0 : static_cast<size_t>(cell_gap(rows[begin].kind, cell)));
  }
  const bool alone = rows[begin].cells.empty();
  append(
      lines, [&](size_t i) -> const std::string& { return rows[begin + i].comment; },
      alone ? 0 : 2);
  for (const std::string& line : lines) out += line + '\n';
}

}  // namespace

int cell_gap(const std::string& kind, size_t cell) {
  const bool wide = (kind == "param" && cell >= 2) || (kind == "rule" && cell == 4);
  return wide ? 2 : 1;
}

std::string align_columns(const std::vector<FormattedLine>& rows) {
  std::string out;
  for (size_t begin = 0, end; begin < rows.size(); begin = end) {
    for (end = begin + 1; end < rows.size(); ++end) {
      const FormattedLine &first = rows[begin], &next = rows[end];
      if (first.kind.empty() || next.kind != first.kind || next.indent != first.indent ||
          next.blank_before)
        break;
    }
    if (rows[begin].blank_before && begin > 0) out += '\n';
    write_run(rows, begin, end, out);
  }
  return out;
}

}  // namespace vug::scene
