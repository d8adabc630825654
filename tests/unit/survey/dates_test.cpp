// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/dates.h>

#include <gtest/gtest.h>

namespace vug::survey {
namespace {

TEST(Dates, AllFormsOfDates) {
  const auto range = [](const char* text) {
    return parse_dates(text).range.value_or(DateRange{-1, -1});
  };
  EXPECT_EQ(range("1900.01.01"), (DateRange{0, 0}));
  EXPECT_EQ(range("1900"), (DateRange{0, 364}));
  EXPECT_EQ(range("1904.02"), (DateRange{1491, 1519}));
  EXPECT_EQ(range("2000-02-29"), (DateRange{36583, 36583}));
  EXPECT_EQ(range("2000.02.28-2000.03.01"), (DateRange{36582, 36584}));
  EXPECT_EQ(range("2000-02-28:2000-03-01"), (DateRange{36582, 36584}));
  EXPECT_EQ(range("2000.02.28 - 2000.03.01"), (DateRange{36582, 36584}));
  EXPECT_EQ(range("explored 1999.01.01 surveyed 2000.02.29"), (DateRange{36583, 36583}));
  EXPECT_EQ(range("1999-2000"), (DateRange{36159, 36889}));
  EXPECT_EQ(parse_dates("99.01.01").range, parse_dates("1999.01.01").range);
  EXPECT_FALSE(parse_dates("99.01.01").warning.empty());
}

TEST(Dates, DaysAndTextsAgreeOverCenturies) {
  int day = day_number(1850, 1, 1);
  for (int year = 1850; year < 2110; ++year)
    for (int month = 1; month <= 12; ++month)
      for (int d = 1; d <= 28; d += 9) {
        const int number = day_number(year, month, d);
        EXPECT_GE(number, day);
        day = number;
        EXPECT_EQ(parse_dates(date_text(number)).range, (DateRange{number, number}));
        EXPECT_EQ(static_cast<int>(year_of(number)), year);
      }
  EXPECT_EQ(day_number(2000, 1, 1), 36524);
}

TEST(Dates, SeparateWords) {
  EXPECT_EQ(parse_date({"2000", "02", "29"}).range, parse_dates("2000-02-29").range);
  EXPECT_EQ(parse_date({"79", "7", "10"}).range, parse_dates("1979-07-10").range);
  EXPECT_EQ(parse_date({"1999", "2", "29"}).fault, "the day of '1999-2-29' does not exist");
  EXPECT_EQ(parse_date({"1999", "2", "0"}).fault, "the day of '1999-2-0' does not exist");
  EXPECT_EQ(parse_date({"1999", "0", "1"}).fault, "the month of '1999-0-1' is not from 1 to 12");
  EXPECT_EQ(parse_date({"199", "1", "1"}).fault, "the year of '199-1-1' is out of range");
  for (const DateWords& words : {DateWords{"", "1", "1"}, DateWords{"1999", "1", "1x"},
                                 DateWords{"1999", "-1", "1"}, DateWords{"9999999999", "1", "1"}})
    EXPECT_FALSE(parse_date(words).range);
}

TEST(Dates, FaultsAreNamed) {
  EXPECT_EQ(parse_dates("2001.02.29").fault, "the day of '2001.02.29' does not exist");
  EXPECT_EQ(parse_dates("2001.13").fault, "the month of '2001.13' is not from 1 to 12");
  EXPECT_EQ(parse_dates("yesterday").fault, "expected a date, found 'yesterday'");
  EXPECT_EQ(parse_dates("2001.02.03 now").fault, "unexpected 'now' after the date");
  EXPECT_EQ(parse_dates("1990.01.02 1990.01.01-2020.12.31").fault,
            "unexpected '1990.01.01-2020.12.31' after the date");
  EXPECT_EQ(parse_dates("1990.01.0").fault, "the day of '1990.01.0' does not exist");
  EXPECT_EQ(parse_dates("1990.0").fault, "the month of '1990.0' is not from 1 to 12");
  EXPECT_EQ(parse_dates("2001.02.03-2001.02.02").fault, "the second date is before the first");
  EXPECT_EQ(parse_dates("99999999999").fault, "expected a date, found '99999999999'");
}

}  // namespace
}  // namespace vug::survey
