// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/scene/text_at.h>

#include <algorithm>

namespace vug::scene {

size_t byte_at(std::string_view text, int line, int column) {
  size_t at = 0;
  for (; line > 1; --line) {
    const size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return text.size();
    at = end + 1;
  }
  while (at < text.size() && text[at] != '\n' && --column > 0) {
    ++at;
    while (at < text.size() && is_utf8_tail(text[at])) ++at;
  }
  return at;
}

std::string_view text_at(std::string_view text, const SourceLocation& where) {
  if (!where.has_end()) return {};
  const size_t begin = byte_at(text, where.line, where.column);
  return text.substr(begin,
                     std::max(begin, byte_at(text, where.end_line, where.end_column)) - begin);
}

}  // namespace vug::scene
