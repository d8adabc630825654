// SPDX-License-Identifier: Apache-2.0
// The lines of a Therion text as lists of tokens [@therion2024].
#pragma once

#include <vug/survey_files/text_encoding.h>
#include <vug/survey_files/text_lines.h>

namespace vug::survey::therion {

struct Token {
  std::string text;
  SourceLocation where;
  enum class Kind { word, quoted, bracketed } kind = Kind::word;

  bool is_word() const { return kind == Kind::word; }
};

[[noreturn]] inline void fail(const std::string& message, const SourceLocation& where,
                              std::string hint) {
  throw Error(ErrorCode::bad_input, message, where, std::move(hint));
}

/// Lines that end with a backslash continue on the next one; '#' starts a comment; texts in quotes
/// (a doubled quote is a quote) and in square brackets are single tokens.
class Tokens {
 public:
  Tokens(std::string_view text, std::string file) : lines_(text, std::move(file)) {}

  /// Moves to the next line that is not blank; false at the end of the text. Throws
  /// Error(bad_input) for a quote or bracket that is not closed and for invalid characters.
  bool next();
  const std::vector<Token>& line() const { return tokens_; }
  /// The encoding of the lines that follow.
  void set_encoding(Encoding encoding) { encoding_ = encoding; }

 private:
  /// Adds the tokens of a line; true if the line continues.
  bool add_tokens(const std::string& line);

  TextLines lines_;
  Encoding encoding_ = Encoding::utf8;
  std::vector<Token> tokens_;
};

}  // namespace vug::survey::therion
