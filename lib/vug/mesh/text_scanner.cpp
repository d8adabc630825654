// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/text_scanner.h>

#include <charconv>
#include <cmath>

namespace vug::mesh {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

void TextScanner::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

std::string_view TextScanner::word_in_line() {
  skip_blanks();
  const size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextScanner::word() {
  for (;;) {
    const std::string_view found = word_in_line();
    if (!found.empty() || !next_line()) return found;
  }
}

bool TextScanner::next_line() {
  const size_t end = text_.find('\n', at_);
  if (end == std::string_view::npos) {
    at_ = text_.size();
    return false;
  }
  at_ = end + 1;
  ++line_;
  return true;
}

std::string_view TextScanner::rest_of_line() {
  const size_t begin = at_;
  const size_t end = std::min(text_.find('\n', at_), text_.size());
  next_line();
  std::string_view rest = text_.substr(begin, end - begin);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

double TextScanner::number(std::string_view word) const {
  if (word.empty()) fail("a number is missing", "the file may be cut off");
  if (word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code == std::errc::invalid_argument || end != word.data() + word.size())
    fail("'" + printable(word) + "' is not a number");
  // Values too small for a double count as 0; too large ones are errors.
  if (code == std::errc::result_out_of_range && word.find("e-") == std::string_view::npos &&
      word.find("E-") == std::string_view::npos)
    fail("'" + printable(word) + "' is too large");
  if (!std::isfinite(value)) fail("'" + printable(word) + "' is not a finite number");
  return value;
}

int64_t TextScanner::integer(std::string_view word) const {
  if (word.empty()) fail("an integer is missing", "the file may be cut off");
  int64_t value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc() || end != word.data() + word.size())
    fail("'" + printable(word) + "' is not an integer");
  return value;
}

void TextScanner::fail(const std::string& message, const std::string& hint) const {
  const bool in_last_line = text_.find('\n', at_) == std::string_view::npos;
  throw Error(ErrorCode::bad_input, message, {file_, line_, 1},
              hint.empty() && in_last_line ? "the file may be cut off" : hint);
}

std::string printable(std::string_view word) {
  std::string text;
  for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
  return word.size() > 24 ? text + "..." : text;
}

}  // namespace vug::mesh
