// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/comments.h>

#include <algorithm>

namespace vug::mesh {
namespace {

constexpr size_t kMost = 160;
constexpr std::string_view kPrefixes[] = {"# ", "comment "};

/// Splits a text without line ends into pieces that do not break an escape.
std::vector<std::string> pieces(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (out.back().size() >= kMost) out.emplace_back();
    if (c == '\n')
      out.back() += "\\n", out.emplace_back();
    else if (c == '\r')
      out.back() += "\\r";
    else if (c == '\\')
      out.back() += "\\\\";
    else
      out.back() += c;
  }
  if (out.back().empty() && out.size() > 1) out.pop_back();
  return out;
}

void append_plain(std::string_view piece, std::string& text) {
  for (size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] != '\\' || i + 1 == piece.size()) {
      text += piece[i];
      continue;
    }
    ++i;
    text += piece[i] == 'n' ? '\n' : piece[i] == 'r' ? '\r' : piece[i];
  }
}

}  // namespace

std::string comment_lines(const Comments& notes, std::string_view prefix) {
  std::string out = std::string(prefix) + "Vug mesh, " + notes.space + "\n";
  for (const auto& [name, text] : notes.texts)
    for (const std::string& piece : pieces(text))
      out.append(prefix).append(name).append(" |").append(piece).append("|\n");
  return out;
}

std::vector<std::pair<std::string, std::string>> read_comments(std::string_view bytes) {
  std::vector<std::pair<std::string, std::string>> texts;
  while (!bytes.empty()) {
    const size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (line == "ply" || line.substr(0, 7) == "format ") continue;
    const auto prefix = std::find_if(std::begin(kPrefixes), std::end(kPrefixes), [&](auto each) {
      return line.substr(0, each.size()) == each;
    });
    if (prefix == std::end(kPrefixes)) break;
    line.remove_prefix(prefix->size());
    const size_t bar = line.find(" |");
    if (bar == std::string_view::npos || line.back() != '|' || line.size() < bar + 3) continue;
    const std::string_view name = line.substr(0, bar);
    if (texts.empty() || texts.back().first != name) texts.emplace_back(name, "");
    append_plain(line.substr(bar + 2, line.size() - bar - 3), texts.back().second);
  }
  return texts;
}

}  // namespace vug::mesh
