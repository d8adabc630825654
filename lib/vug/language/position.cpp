// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/language/position.h>
#include <vug/scene/text_at.h>

#include <algorithm>
#include <cctype>

namespace vug::language {

bool touches(const SourceLocation& where, const Position& position) {
  return where.has_end() && begin_of(where) <= position && position <= end_of(where);
}

SourceLocation range_at(const std::string& file, const Position& position) {
  return range_between(file, position, position);
}

SourceLocation range_between(const std::string& file, const Position& begin, const Position& end) {
  return {file, begin.line, begin.column, end.line, end.column};
}

Position position_at(const std::string& text, size_t byte) {
  byte = std::min(byte, text.size());
  while (byte > 0 && byte < text.size() && is_utf8_tail(text[byte])) --byte;
  const std::string_view before(text.data(), byte);
  const size_t line = before.rfind('\n') + 1;  // 0 on the first line
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          1 + utf8_count(before.substr(line))};
}

size_t unit_begin(std::string_view number) {
  size_t at = number.size();
  while (at > 0 &&
         (std::isalpha(static_cast<unsigned char>(number[at - 1])) || number[at - 1] == '%'))
    --at;
  return at;
}

std::string apply(std::string text, std::vector<TextEdit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const TextEdit& a, const TextEdit& b) {
    return begin_of(a.range) < begin_of(b.range);
  });
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
    const size_t begin = scene::byte_at(text, edit->range.line, edit->range.column);
    const size_t end = scene::byte_at(text, edit->range.end_line, edit->range.end_column);
    text.replace(begin, std::max(begin, end) - begin, edit->text);
  }
  return text;
}

}  // namespace vug::language
