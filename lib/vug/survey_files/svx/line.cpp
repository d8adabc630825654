// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/survey_files/svx/line.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vug::survey::svx {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Coordinates and readings beyond this are errors of typing, in any unit.
constexpr double kLargest = 1e9;

}  // namespace

char Line::peek() {
  while (is(at(0), kBlank)) ++here_;
  return at(0);
}

bool Line::at_end() {
  const char next = peek();
  if (next != 0 && !is(next, kComment)) return false;
  here_ = text_.size();
  return true;
}

std::string Line::keyword() {
  peek();
  std::string all;
  for (; is_letter(at(0)); ++here_) all += lower_case(at(0));
  return all;
}

size_t Line::word_end(size_t from) const {
  while (from < text_.size() && !is(text_[from], kBlank) && !is(text_[from], kComment)) ++from;
  return from;
}

std::string Line::word() {
  peek();
  const size_t start = here_;
  here_ = word_end(start);
  return std::string(text_.substr(start, here_ - start));
}

std::string Line::text() {
  if (peek() != '"') return word();
  const size_t start = here_, end = text_.find('"', start + 1);
  if (end == std::string_view::npos)
    fail(start, "the text has no closing '\"'", "a text ends on its line");
  here_ = end + 1;
  return std::string(text_.substr(start + 1, end - start - 1));
}

std::string_view Line::rest() {
  peek();
  const size_t start = here_;
  while (here_ < text_.size() && !is(text_[here_], kComment)) ++here_;
  size_t end = here_;
  while (end > start && is(text_[end - 1], kBlank)) --end;
  return text_.substr(start, end - start);
}

std::optional<double> Line::try_number() {
  peek();
  const size_t start = here_;
  size_t end = start;
  std::string digits;
  const auto more = [&] { return end < text_.size() ? text_[end] : '\0'; };
  if (is(more(), kMinus)) digits += '-';
  if (is(more(), kMinus) || is(more(), kPlus)) ++end;
  bool any = false, point = false;
  for (; is_digit(more()) || (!point && is(more(), kDecimal)); ++end) {
    any = any || is_digit(more());
    point = point || !is_digit(more());
    digits += is_digit(more()) ? more() : '.';
  }
  if (!any) return std::nullopt;
  here_ = end;
  double value = 0;
  const auto [last, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool tiny = code == std::errc::result_out_of_range && digits.find('.') < 30;
  if (tiny) return 0.0;
  if (code != std::errc() || std::fabs(value) > kLargest)
    fail(start, "the number is too large", "numbers are at most 1e9");
  return value;
}

double Line::number(const char* what) {
  const std::optional<double> value = try_number();
  if (!value) fail_expected(what, "numbers are decimal, e.g. 12.5 or -3");
  return *value;
}

void Line::require_end() {
  if (at_end()) return;
  const size_t start = here_;
  here_ = word_end(start);
  fail(start,
       fmt::format("unexpected '{}' at the end of the line", text_.substr(start, here_ - start)),
       "a comment begins with ';'");
}

int Line::column(size_t position) const {
  return 1 + utf8_count(text_.substr(0, std::min(position, text_.size())));
}

SourceLocation Line::range(size_t start) const {
  return {*file_, number_, column(start), number_, std::max(column(here_), column(start) + 1)};
}

SourceLocation Line::word_at(size_t position) const {
  Line copy = *this;
  copy.here_ = word_end(position);
  return copy.range(position);
}

void Line::fail(size_t start, const std::string& message, const std::string& hint) const {
  throw Error(ErrorCode::bad_input, message, range(start), hint);
}

void Line::fail_expected(const std::string& what, const std::string& hint) {
  const bool end = at_end();
  const size_t start = here_;
  here_ = word_end(start);
  const std::string_view found = text_.substr(start, here_ - start);
  fail(start,
       end ? fmt::format("expected {}, found the end of the line", what)
           : fmt::format("expected {}, found '{}'", what, found),
       hint);
}

}  // namespace vug::survey::svx
