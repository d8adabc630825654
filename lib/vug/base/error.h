// The one exception type of the library, and where in a user's text a fault lies.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// A place in a text file; line and column count from 1, 0 means unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;

  bool known() const { return line > 0; }
  bool operator==(const SourceLocation&) const = default;
};

/// "file:line:column", as much of it as is known.
std::string to_string(const SourceLocation& where);

/// What kind of fault; the command line maps these to exit codes.
enum class ErrorCode {
  bad_input,  ///< The user's text, file or argument cannot be used (exit 2).
  too_large,  ///< The work would exceed a limit the user set (exit 2).
  io,         ///< The system refused to read or write (exit 3).
  cancelled,  ///< Progress was told to stop (exit 3).
  internal,   ///< A promise of ours is broken (exit 3).
};

/// Thrown by every module. The message is a full sentence without a final stop; `hint` says
/// what to do about it; `context` is the chain of "while ..." lines, innermost first.
class Error : public std::runtime_error {
 public:
  explicit Error(ErrorCode code, const std::string& message, SourceLocation where = {},
                 std::string hint = {});

  ErrorCode code() const { return code_; }
  const SourceLocation& where() const { return where_; }
  const std::string& hint() const { return hint_; }
  const std::vector<std::string>& context() const { return context_; }

  /// The same error at `where`, without its context.
  Error at(const SourceLocation& where) const { return Error(code_, what(), where, hint_); }
  /// Adds a "while ..." line as the error travels outwards.
  Error& within(std::string doing);

 private:
  ErrorCode code_;
  SourceLocation where_;
  std::string hint_;
  std::vector<std::string> context_;
};

}  // namespace vug
