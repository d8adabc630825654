// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/dates.h>
#include <vug/survey_files/compass/dat_header.h>

#include <fmt/format.h>

namespace vug::survey::compass {
namespace {

constexpr const char* kOrder =
    "a header has the lines cave, SURVEY NAME:, SURVEY DATE:, SURVEY TEAM:, the team, "
    "DECLINATION:, "
    "and the titles of columns";

void next_line(TextLines& lines) {
  if (!lines.next()) lines.fail("the file ends inside the header of a survey", kOrder);
}

/// The text after the keyword at the start of the current line.
std::string_view after(TextLines& lines, std::string_view keyword) {
  const std::string_view line = trimmed(lines.line());
  if (!line.starts_with(keyword))
    lines.fail(fmt::format("expected '{}', found {}", keyword, quote_text(line)), kOrder);
  return trimmed(line.substr(keyword.size()));
}

double number(const TextLines& lines, const std::vector<Word>& words, size_t index) {
  if (index >= words.size())
    lines.fail("the line ends where a number is expected", "add the number");
  const auto value = parse_number(words[index].text);
  if (!value)
    lines.fail(fmt::format("{} is not a number", quote_text(words[index].text)), words[index],
               "write a decimal number such as 1.50");
  if (*value < -360 || *value > 360)
    lines.fail(fmt::format("the correction {} is not between -360 and 360", *value), words[index],
               "write angles in degrees and lengths in feet");
  return *value;
}

/// Month, day and year.
std::optional<DateRange> read_date(const TextLines& lines, std::string_view text) {
  const std::vector<Word> words = split_words(text.substr(0, text.find("COMMENT:")));
  if (words.empty()) return std::nullopt;
  constexpr const char* kForm = "write the month, the day and the year, such as 7 10 1979";
  if (words.size() != 3)
    lines.fail(fmt::format("{} is not a date", quote_text(trimmed(text))), kForm);
  const DateText date = parse_date({words[2].text, words[0].text, words[1].text});
  if (!date.range) lines.fail(date.fault, kForm);
  return date.range;
}

void read_format(DatHeader& header, const TextLines& lines, const Word& word) {
  const std::string format = lower_case(word.text);
  if (format.size() < 11 || format.size() > 15)
    lines.fail(
        fmt::format("the FORMAT {} does not have 11 to 15 characters", quote_text(word.text)), word,
        "four units, four dimensions, three or five readings, B or N, F or T");
  if (format.size() == 14)
    lines.fail("a FORMAT of 14 characters is ambiguous", word, "use 13 or 15 characters");
  const size_t readings = format.size() == 15 ? 5 : 3;
  if (format.size() > 8 + readings) header.has_backsights = format[8 + readings] == 'b';
  if (format.size() > 9 + readings) header.sections_at_to = format[9 + readings] == 't';
}

void read_settings(DatHeader& header, const TextLines& lines) {
  const std::vector<Word> words = split_words(lines.line());
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string_view keyword = words[i].text;
    if (keyword == "DECLINATION:") {
      header.declination = number(lines, words, ++i);
    } else if (keyword == "FORMAT:") {
      if (++i >= words.size()) lines.fail("the line ends after FORMAT:", "add the format");
      read_format(header, lines, words[i]);
    } else if (keyword == "CORRECTIONS:") {
      header.fore = {number(lines, words, i + 1), number(lines, words, i + 2),
                     number(lines, words, i + 3)};
      i += 3;
    } else if (keyword == "CORRECTIONS2:") {
      header.back = {number(lines, words, i + 1), number(lines, words, i + 2), 0};
      i += 2;
    } else if (keyword == "DISCOVERY:") {
      break;  // The date of the discovery.
    } else {
      lines.fail(fmt::format("unknown setting {}", quote_text(keyword)), words[i],
                 "known: DECLINATION:, FORMAT:, CORRECTIONS:, CORRECTIONS2:, DISCOVERY:");
    }
  }
}

}  // namespace

DatHeader read_dat_header(TextLines& lines) {
  DatHeader header;
  header.cave = trimmed(lines.line());
  next_line(lines);
  header.name = after(lines, "SURVEY NAME:");
  next_line(lines);
  header.date = read_date(lines, after(lines, "SURVEY DATE:"));
  next_line(lines);
  after(lines, "SURVEY TEAM:");
  next_line(lines);  // The names of the team; the line may be empty.
  next_line(lines);
  after(lines, "DECLINATION:");
  read_settings(header, lines);
  do next_line(lines);
  while (trimmed(lines.line()).empty());
  after(lines, "FROM");
  return header;
}

}  // namespace vug::survey::compass
