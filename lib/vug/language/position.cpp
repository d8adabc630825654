// SPDX-License-Identifier: Apache-2.0
#include <vug/language/position.h>
#include <vug/scene/text_at.h>

#include <algorithm>

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
