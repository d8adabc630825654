// SPDX-License-Identifier: Apache-2.0
// A scanner for words and numbers in the text of a mesh file, with line numbers for messages.
#pragma once

#include <vug/base/error.h>

#include <string>
#include <string_view>

namespace vug::mesh {

/// Reads forward over a text that it does not own. Lines end with \n or \r\n.
class TextScanner {
 public:
  TextScanner(std::string_view text, std::string file, size_t start = 0, int line = 1)
      : text_(text), file_(std::move(file)), at_(start), line_(line) {}

  /// The next word, across line ends; empty at the end of the text.
  std::string_view word();
  /// The next word on this line; empty at the end of the line, which is not consumed.
  std::string_view word_in_line();
  /// Advances to the start of the next line; false at the end of the text.
  bool next_line();
  /// The rest of this line without its line end, which is consumed.
  std::string_view rest_of_line();

  double number(std::string_view word) const;    ///< Finite, or throws Error.
  int64_t integer(std::string_view word) const;  ///< An integer, or throws Error.

  size_t offset() const { return at_; }
  int line() const { return line_; }
  size_t left() const { return text_.size() - at_; }
  std::string_view text() const { return text_; }

  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const;

 private:
  void skip_blanks();

  std::string_view text_;
  std::string file_;
  size_t at_;
  int line_;
};

/// `word` as quoted in messages: shortened and without unprintable bytes.
std::string printable(std::string_view word);

}  // namespace vug::mesh
