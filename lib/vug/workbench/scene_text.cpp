// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/utf8.h>
#include <vug/workbench/scene_text.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::workbench {
namespace {

constexpr const char* kByteOrderMark = "\xef\xbb\xbf";

bool splits_character(const std::string& text, size_t at) {
  return at < text.size() && is_utf8_tail(text[at]);
}

}  // namespace

TextChange change_between(const std::string& before, const std::string& after) {
  const size_t most = std::min(before.size(), after.size());
  size_t begin = 0;
  while (begin < most && before[begin] == after[begin]) ++begin;
  while (begin > 0 && (splits_character(before, begin) || splits_character(after, begin))) --begin;
  size_t same = 0;
  while (same < most - begin && before[before.size() - 1 - same] == after[after.size() - 1 - same])
    ++same;
  while (same > 0 && splits_character(after, after.size() - same)) --same;
  return {begin, before.size() - same - begin, after.substr(begin, after.size() - same - begin)};
}

std::string with_change(const std::string& text, const TextChange& change) {
  if (change.begin > text.size() || change.removed > text.size() - change.begin ||
      splits_character(text, change.begin) || splits_character(text, change.begin + change.removed))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the text has no range of {} bytes from byte {}", change.removed, change.begin),
        {}, fmt::format("it has {} bytes; ranges contain whole characters", text.size()));
  std::string out = text;
  return out.replace(change.begin, change.removed, change.text);
}

std::string changed_lines(const std::string& before, const std::string& after) {
  const TextChange change = change_between(before, after);
  const auto line = [&](size_t at) {
    return 1 + std::count(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  };
  // The end of a change is behind its last character.
  const auto first = line(change.begin),
             last = line(change.text.empty() ? change.begin : change.end() - 1);
  return first == last ? fmt::format("line {}", first) : fmt::format("lines {} to {}", first, last);
}

FileConventions conventions_of(const std::string& file_text) {
  return {file_text.find("\r\n") != std::string::npos, file_text.rfind(kByteOrderMark, 0) == 0};
}

std::string with_conventions(const std::string& text, const FileConventions& conventions) {
  std::string out = conventions.mark ? kByteOrderMark : "";
  for (const char c : text) {
    if (c == '\n' && conventions.crlf) out += '\r';
    out += c;
  }
  return out;
}

}  // namespace vug::workbench
