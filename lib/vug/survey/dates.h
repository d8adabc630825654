// SPDX-License-Identifier: Apache-2.0
// Dates of surveys.
#pragma once

#include <vug/survey/survey.h>

#include <string>
#include <string_view>

namespace vug::survey {

/// Days from 1900-01-01 to a date of the Gregorian calendar; negative before.
int day_number(int year, int month, int day);

/// The year with its fraction at noon of a day: 1900.0 is the start of 1900.
double year_of(int day);

/// "2024-07-12" for a day.
std::string date_text(int day);

/// The result of parsing dates: a range, or a fault of the text.
struct DateText {
  std::optional<DateRange> range;
  std::string fault;    ///< Empty if the text is a date.
  std::string warning;  ///< E.g. for a year with two digits.
};

/// Parses a date or a range, as Survex and Therion write them: "2024", "2024.07", "2024.07.12",
/// "2024-07-12", "2024.07.12-2024.08.01", "2024-07-12:2024-08-01". A year or a month is the range
/// of its days. The words "surveyed" and "explored" may precede a date; explored dates are ignored.
DateText parse_dates(std::string_view text);

/// A day of which the parts are separate words, as Compass and Walls write it.
struct DateWords {
  std::string_view year;  ///< Two digits are a year of the 20th century.
  std::string_view month;
  std::string_view day;
};
DateText parse_date(const DateWords& words);

}  // namespace vug::survey
