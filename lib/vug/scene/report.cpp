// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>
#include <vug/scene/text_at.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <tuple>

namespace vug::scene {

namespace {

/// Maximum length of the displayed part of a line.
constexpr size_t kWidth = 160;

/// Maximum number of stored errors; see ParseOptions::max_errors.
const size_t kKept = static_cast<size_t>(ParseOptions().max_errors);

std::string_view line_of(std::string_view text, int line) {
  while (--line > 0) {
    const size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

/// Byte after the last underlined character; more than one line is underlined up to its end.
size_t end_of(std::string_view line, const SourceLocation& where) {
  if (!where.has_end()) return 0;
  if (where.end_line == where.line) return byte_at(line, 1, where.end_column);
  return line.find_last_not_of(" \t") + 1;
}

/// The line with its range underlined; a long line is cut to the neighbourhood of the start.
std::string excerpt(std::string_view line, const SourceLocation& where) {
  size_t at = byte_at(line, 1, where.column), end_at = end_of(line, where);
  if (line.size() > kWidth) {
    size_t from = at > kWidth / 2 ? at - kWidth / 2 : 0;
    while (from > 0 && is_utf8_tail(line[from])) --from;
    size_t end = std::min(line.size(), from + kWidth);
    while (end < line.size() && is_utf8_tail(line[end])) ++end;
    line = line.substr(from, end - from);
    at -= from;
    end_at -= std::min(end_at, from);
  }
  const std::string before = printable(line.substr(0, at));
  std::string caret;
  for (const char c : before)
    if (!is_utf8_tail(c)) caret += c == '\t' ? '\t' : ' ';
  const std::string rest = printable(line.substr(at));
  const std::string range =
      printable(line.substr(at, std::max(at, std::min(end_at, line.size())) - at));
  const int tildes = std::max(utf8_count(range) - 1, 0);
  return fmt::format("{}\n{}^{:~>{}}\n", before + rest, caret, "", tildes);
}

}  // namespace

std::string report(const Diagnostics& diagnostics,
                   const std::vector<std::shared_ptr<const Source>>& sources, int limit) {
  const auto rank = [&](const std::string& file) {
    const auto found = std::find_if(sources.begin(), sources.end(),
                                    [&](const auto& source) { return source->file == file; });
    return static_cast<size_t>(found - sources.begin());
  };
  struct LocatedDiagnostic {
    size_t rank;
    const Diagnostic* what;
  };
  std::vector<LocatedDiagnostic> rows;
  for (const Diagnostic& one : diagnostics.all()) rows.push_back({rank(one.where.file), &one});
  const auto order = [](const LocatedDiagnostic& row) {
    const Diagnostic& d = *row.what;
    return std::tie(row.rank, d.where.file, d.where.line, d.where.column);
  };
  std::stable_sort(
      rows.begin(), rows.end(),
      [&](const LocatedDiagnostic& a, const LocatedDiagnostic& b) { return order(a) < order(b); });
  const auto same = [&](const LocatedDiagnostic& a, const LocatedDiagnostic& b) {
    return order(a) == order(b) && a.what->message == b.what->message;
  };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());

  std::string out;
  const size_t shown = std::min(rows.size(), static_cast<size_t>(std::max(limit, 0)));
  for (size_t i = 0; i < shown; ++i) {
    const Diagnostic& d = *rows[i].what;
    const std::string place = printable(to_string(d.where));
    out += fmt::format("{}{}{}: {}\n", place, place.empty() ? "" : ": ",
                       d.severity == Severity::error ? "error" : "warning", printable(d.message));
    if (d.where.known() && rows[i].rank < sources.size())
      out += excerpt(line_of(sources[rows[i].rank]->text, d.where.line), d.where);
    if (!d.hint.empty()) out += fmt::format("hint: {}\n", printable(d.hint));
  }
  if (rows.size() > shown)
    out += fmt::format("... and {}{} more\n", rows.size() >= kKept ? "at least " : "",
                       rows.size() - shown);
  return out;
}

}  // namespace vug::scene
