// SPDX-License-Identifier: Apache-2.0
// A cursor over one line of a .svx file, with errors that name the column.
#pragma once

#include <vug/base/error.h>
#include <vug/survey_files/svx/characters.h>

#include <optional>
#include <string>
#include <string_view>

namespace vug::survey::svx {

/// Refers to the texts and characters that it is made from.
class Line {
 public:
  Line(std::string_view text, const std::string& file, int number, const Characters& characters)
      : text_(text), file_(&file), number_(number), characters_(&characters) {}

  /// Whether only blanks and a comment remain; moves to their end.
  bool at_end();
  /// The next character after blanks, or 0 at the end of the line.
  char peek();
  /// The character `offset` bytes after the cursor, or 0 at the end of the line.
  char at(size_t offset) const { return here_ + offset < text_.size() ? text_[here_ + offset] : 0; }
  void skip(size_t bytes) { here_ += bytes; }
  bool is(char c, CharacterClass in) const { return c != 0 && characters_->is(c, in); }

  /// The next word of letters, in lower case; empty if another character follows.
  std::string keyword();
  /// The next characters up to a blank or the end.
  std::string word();
  /// A text in double quotes, or a word.
  std::string text();
  /// The rest of the line without its comment.
  std::string_view rest();
  /// A number, e.g. "-3.5"; nothing if another character follows.
  std::optional<double> try_number();
  /// Error for another text; `what` is its name in the message.
  double number(const char* what);
  /// Error unless only a comment remains.
  void require_end();

  size_t position() const { return here_; }
  void set_position(size_t position) { here_ = position; }
  /// The range from `start` to the cursor.
  SourceLocation range(size_t start) const;
  /// The word at a position.
  SourceLocation word_at(size_t position) const;
  [[noreturn]] void fail(size_t start, const std::string& message,
                         const std::string& hint = {}) const;
  /// "expected `what`, found 'x'", at the next word.
  [[noreturn]] void fail_expected(const std::string& what, const std::string& hint = {});

 private:
  size_t word_end(size_t from) const;
  int column(size_t position) const;

  std::string_view text_;
  const std::string* file_;
  int number_;
  const Characters* characters_;
  size_t here_ = 0;
};

}  // namespace vug::survey::svx
