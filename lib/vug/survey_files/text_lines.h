// SPDX-License-Identifier: Apache-2.0
// The lines of a survey text and their words, with locations for messages.
#pragma once

#include <vug/base/error.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::survey {

/// A word with the position in bytes of its first character in its line, from 0.
struct Word {
  std::string_view text;
  size_t start = 0;
};

/// The words between any of the characters of `separators`.
std::vector<Word> split_words(std::string_view line, std::string_view separators = " \t");

std::string_view trimmed(std::string_view text);

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

/// The value of a decimal number with an optional sign and exponent; nothing for other texts and
/// numbers that are not finite.
std::optional<double> parse_number(std::string_view text);

/// A whole number from `low` to `high`; nothing for other texts.
std::optional<int> parse_integer(std::string_view text, int low, int high);

/// Reads lines that end with LF, CR LF or CR. A byte order mark before the first one is skipped.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  /// Moves to the next line; false at the end of the text.
  bool next();
  std::string_view line() const { return line_; }
  /// The number of the line, from 1.
  int number() const { return number_; }
  const std::string& file() const { return file_; }

  /// The location of a range of bytes of the line; columns count characters of UTF-8.
  SourceLocation at(size_t start = 0, size_t length = 0) const;
  SourceLocation at(const Word& word) const { return at(word.start, word.text.size()); }
  [[noreturn]] void fail(const std::string& message, const Word& word, std::string hint) const;
  [[noreturn]] void fail(const std::string& message, std::string hint) const;

 private:
  std::string_view text_;
  std::string file_;
  std::string_view line_;
  size_t next_ = 0;
  int number_ = 0;
};

/// The text in quotes, shortened and without control characters, for messages.
std::string quote_text(std::string_view text);

}  // namespace vug::survey
