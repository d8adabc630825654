// SPDX-License-Identifier: Apache-2.0
// The library's exception type and locations in a user's text.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// A range of characters in a text file, or a position if its end is unknown. Lines and columns
/// count from 1, columns in characters (UTF-8); 0 means unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
  int end_line = 0;
  int end_column = 0;  ///< The column after the last character.

  bool known() const { return line > 0; }
  bool has_end() const { return end_line > 0; }
  /// The range from the start of this one to the end of `last`, which is in the same file.
  SourceLocation up_to(const SourceLocation& last) const;
  /// Whether both have an end and `inner` lies within this range.
  bool contains(const SourceLocation& inner) const;
  bool operator==(const SourceLocation&) const = default;
};

/// "file:line:column", or only the file if the line is unknown.
std::string to_string(const SourceLocation& where);
/// "file:line:column-line:column", without the part that is unknown.
std::string range_text(const SourceLocation& where);

/// The category of an error; the command line maps it to an exit code.
enum class ErrorCode {
  bad_input,  ///< The user's text, file or argument is invalid (exit 2).
  too_large,  ///< The work would exceed a limit set by the user (exit 2).
  io,         ///< The system failed to read or write (exit 3).
  cancelled,  ///< The work was cancelled through Progress (exit 3).
  internal,   ///< An invariant of the library is broken (exit 3).
};

/// Thrown by every module. The message is a full sentence without a final stop; `hint` suggests a
/// remedy; `context` is the chain of "while ..." lines, innermost first.
class Error : public std::runtime_error {
 public:
  explicit Error(ErrorCode code, const std::string& message, SourceLocation where = {},
                 std::string hint = {});

  ErrorCode code() const { return code_; }
  const SourceLocation& where() const { return where_; }
  const std::string& hint() const { return hint_; }
  /// The message after the location, if it is known, e.g. "stone.ply:3:1: a face has two corners".
  std::string located_message() const;
  const std::vector<std::string>& context() const { return context_; }

  /// The same error at `where`, without its context.
  Error at(const SourceLocation& where) const { return Error(code_, what(), where, hint_); }
  /// Adds a "while ..." line as the error propagates outwards.
  Error& within(std::string doing);

 private:
  ErrorCode code_;
  SourceLocation where_;
  std::string hint_;
  std::vector<std::string> context_;
};

}  // namespace vug
