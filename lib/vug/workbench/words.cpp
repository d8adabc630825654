// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace vug::workbench {
namespace {

/// The number at the beginning of a word, and the rest of the word.
std::pair<double, std::string> leading_number(const std::string& word) {
  double value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc() || !std::isfinite(value))
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is not a number", word), {},
                "such as 4, 3.4m or 90cm");
  return {value, std::string(end, word.data() + word.size())};
}

}  // namespace

std::vector<std::string> split_words(const std::string& line) {
  std::vector<std::string> out;
  bool in_word = false, in_quotes = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (!in_quotes && (c == ' ' || c == '\t' || c == '\r')) {
      in_word = false;
      continue;
    }
    if (!in_word && c == '#') break;
    if (!in_word) out.emplace_back();
    in_word = true;
    if (c == '"')
      in_quotes = !in_quotes;
    else if (in_quotes && c == '\\' && i + 1 < line.size())
      out.back() += line[++i] == 'n' ? '\n' : line[i];
    else
      out.back() += c;
  }
  if (in_quotes)
    throw Error(ErrorCode::bad_input, fmt::format("a quote is not closed: {}", line), {},
                "close it with \"");
  return out;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\r\n\"\\#") == std::string::npos) return word;
  std::string out = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + '"';
}

double parse_length(const std::string& word) {
  const auto [value, unit] = leading_number(word);
  if (unit.empty() || unit == "m") return value;
  if (unit == "cm") return value / 100;
  throw Error(ErrorCode::bad_input, fmt::format("unknown unit '{}' of a length", unit), {},
              "use m or cm");
}

double parse_number(const std::string& word) {
  const auto [value, rest] = leading_number(word);
  if (rest.empty()) return value;
  throw Error(ErrorCode::bad_input, fmt::format("'{}' is not a number", word), {}, "such as 4");
}

}  // namespace vug::workbench
