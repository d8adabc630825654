// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/dates.h>

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace vug::survey {
namespace {

bool is_leap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

int days_in(int year, int month) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month == 2 && is_leap(year) ? 29 : kDays[static_cast<size_t>(month - 1)];
}

/// Days from 1900-01-01 to the start of a year.
int start_of(int year) {
  const auto leap_days = [](int y) { return y / 4 - y / 100 + y / 400; };
  return 365 * (year - 1900) + leap_days(year - 1) - leap_days(1899);
}

/// Reads digits at the start of the text and removes them; -1 without digits.
int take_number(std::string_view& text) {
  int number = -1;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || text[0] == '-' || code != std::errc()) return -1;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return number;
}

bool take(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

void take_blanks(std::string_view& text) {
  while (take(text, " ") || take(text, "\t")) continue;
}

/// Whether an ISO date starts here: YYYY-MM-DD.
bool is_iso(std::string_view text) {
  constexpr std::string_view kPattern = "dddd-dd-dd";
  if (text.size() < kPattern.size()) return false;
  for (size_t i = 0; i < kPattern.size(); ++i)
    if (kPattern[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != '-') return false;
  return true;
}

/// The days of a date; a month or day of 0 is not given. `written` is its text for messages.
DateText checked_date(int year, int month, int day, std::string_view written) {
  DateText out;
  if (year < 1500 || year > 9999)
    out.fault = fmt::format("the year of '{}' is out of range", written);
  else if (month < 0 || month > 12)
    out.fault = fmt::format("the month of '{}' is not from 1 to 12", written);
  else if (day < 0 || (month > 0 && day > days_in(year, month)))
    out.fault = fmt::format("the day of '{}' does not exist", written);
  else if (month == 0)
    out.range = {start_of(year), start_of(year + 1) - 1};
  else
    out.range = {day_number(year, month, day == 0 ? 1 : day),
                 day_number(year, month, day == 0 ? days_in(year, month) : day)};
  return out;
}

/// Reads one date and removes it.
DateText take_date(std::string_view& text) {
  const std::string_view separator = is_iso(text) ? "-" : ".";
  const size_t before = text.size();
  const std::string_view whole = text;
  int year = take_number(text), month = 0, day = 0;
  const size_t digits = before - text.size();
  if (year < 0) {
    DateText out;
    out.fault = fmt::format("expected a date, found '{}'", text.substr(0, text.find(' ')));
    return out;
  }
  if (digits <= 2) year += 1900;
  // A written 0 is a fault, while a part that is not written is not given.
  const auto take_part = [&] {
    const int part = take_number(text);
    return part == 0 ? -1 : part;
  };
  if (take(text, separator)) month = take_part();
  if (month != 0 && take(text, separator)) day = take_part();
  DateText out = checked_date(year, month, day, whole.substr(0, before - text.size()));
  if (digits <= 2) out.warning = fmt::format("a year with two digits is taken as {}", year);
  return out;
}

/// Reads a date or a range and removes it.
DateText take_range(std::string_view& text) {
  DateText first = take_date(text);
  std::string_view after = text;
  take_blanks(after);
  if (!first.range || !(take(after, "-") || take(after, ":"))) return first;
  take_blanks(after);
  text = after;
  DateText last = take_date(text);
  if (last.range && last.range->last < first.range->first) {
    last.fault = "the second date is before the first";
    last.range.reset();
  }
  if (last.range) last.range->first = first.range->first;
  if (last.warning.empty()) last.warning = first.warning;
  return last;
}

}  // namespace

int day_number(int year, int month, int day) {
  int days = start_of(year);
  for (int m = 1; m < month; ++m) days += days_in(year, m);
  return days + day - 1;
}

double year_of(int day) {
  int year = 1900 + static_cast<int>(day / 365.2425);
  while (start_of(year) > day) --year;
  while (start_of(year + 1) <= day) ++year;
  return year + (day - start_of(year) + 0.5) / (start_of(year + 1) - start_of(year));
}

std::string date_text(int day) {
  const int year = static_cast<int>(year_of(day));
  int month = 1, rest = day - start_of(year);
  while (rest >= days_in(year, month)) rest -= days_in(year, month++);
  return fmt::format("{:04}-{:02}-{:02}", year, month, rest + 1);
}

DateText parse_date(const DateWords& words) {
  const std::string written = fmt::format("{}-{}-{}", words.year, words.month, words.day);
  const auto number = [](std::string_view text) {
    const int value = take_number(text);
    return text.empty() ? value : -1;
  };
  const int year = number(words.year), month = number(words.month), day = number(words.day);
  if (year >= 0 && month >= 0 && day >= 0)
    return checked_date(words.year.size() <= 2 ? year + 1900 : year, month == 0 ? -1 : month,
                        day == 0 ? -1 : day, written);
  DateText out;
  out.fault = fmt::format("'{}' is not a date", written);
  return out;
}

DateText parse_dates(std::string_view text) {
  DateText out;
  bool first = true;
  do {
    const bool explored = take(text, "explored");
    if (!explored && !take(text, "surveyed") && !first) {
      out.fault = fmt::format("unexpected '{}' after the date", text);
      out.range.reset();
      return out;
    }
    first = false;
    take_blanks(text);
    const DateText read = take_range(text);
    if (!read.fault.empty()) return read;
    if (!explored) out = read;
    const size_t size = text.size();
    take_blanks(text);
    if (!text.empty() && text.size() == size) {
      out.fault = fmt::format("expected a date, found '{}'", text);
      out.range.reset();
      return out;
    }
  } while (!text.empty());
  return out;
}

}  // namespace vug::survey
