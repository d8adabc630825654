// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/survey_files/text_lines.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vug::survey {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\x1a'; }

}  // namespace

std::vector<Word> split_words(std::string_view line, std::string_view separators) {
  std::vector<Word> words;
  size_t start = line.find_first_not_of(separators);
  while (start != std::string_view::npos) {
    const size_t end = std::min(line.find_first_of(separators, start), line.size());
    words.push_back({line.substr(start, end - start), start});
    start = line.find_first_not_of(separators, end);
  }
  return words;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<int> parse_integer(std::string_view text, int low, int high) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high)
    return std::nullopt;
  return value;
}

bool TextLines::next() {
  if (next_ >= text_.size()) return false;
  const size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
  line_ = text_.substr(next_, end - next_);
  next_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  ++number_;
  return true;
}

SourceLocation TextLines::at(size_t start, size_t length) const {
  start = std::min(start, line_.size());
  const int column = utf8_count(line_.substr(0, start)) + 1;
  const int end = column + utf8_count(line_.substr(start, length));
  return {file_, number_, column, length > 0 ? number_ : 0, length > 0 ? end : 0};
}

void TextLines::fail(const std::string& message, const Word& word, std::string hint) const {
  throw Error(ErrorCode::bad_input, message, at(word), std::move(hint));
}

void TextLines::fail(const std::string& message, std::string hint) const {
  throw Error(ErrorCode::bad_input, message, at(), std::move(hint));
}

std::string quote_text(std::string_view text) {
  constexpr size_t kLongest = 60;
  std::string shown(text.substr(0, kLongest));
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return "'" + shown + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace vug::survey
