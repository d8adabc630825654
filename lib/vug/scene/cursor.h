// The parser's place in the tokens of one file, and how it fails and finds its feet again.
#pragma once

#include <vug/scene/lexer.h>
#include <vug/scene/parser.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vug::scene {

/// Thrown after a fault was reported; caught where parsing can go on.
struct SyntaxFault {};

class Cursor {
 public:
  /// All arguments must outlive the cursor; `tokens` ends with an end token.
  Cursor(const std::vector<Token>& tokens, const std::string& file, Diagnostics& diagnostics,
         const ParseOptions& options)
      : tokens_(tokens), file_(file), diagnostics_(diagnostics), options_(options) {}

  /// The token `ahead` from here; line breaks are invisible while inside ( ) or [ ].
  const Token& peek(size_t ahead = 0) const;
  /// The token taken last; the first token if none was.
  const Token& last() const { return tokens_[last_]; }
  const Token& take();
  bool accept(std::string_view sign);
  bool at_end() const { return peek().kind == TokenKind::end; }
  /// At a line break or ";", "}" or the end.
  bool at_line_end() const;

  /// Takes `sign` or fails with "expected ... before/instead".
  void expect(std::string_view sign, const std::string& purpose);
  /// Takes a name or fails: "expected `what`, found ...".
  const Token& expect_name(const std::string& what);
  /// Takes line breaks, but not those before a new statement, a "}" or the end.
  void skip_newlines();
  /// The token after any line breaks (not ";"), without taking them.
  const Token& beyond_newlines() const;
  /// Takes line breaks if the first token after them is `sign`, then the sign itself.
  bool accept_beyond_newlines(std::string_view sign);

  SourceLocation where(const Token& token) const { return {file_, token.line, token.column}; }
  const std::string& file() const { return file_; }
  const ParseOptions& options() const { return options_; }
  Diagnostics& diagnostics() const { return diagnostics_; }

  /// How often anything was at fault so far: tokens that were taken and errors, told or dropped.
  int faults() const { return faults_; }
  /// The index of the next token, and the names among the tokens since such an index.
  size_t position() const { return at_; }
  void add_names_since(size_t position, std::set<std::string>& names) const;

  /// Reports at a token and goes on.
  void error(const Token& token, std::string message, std::string hint = {});
  /// Reports at a token and throws SyntaxFault.
  [[noreturn]] void fail(const Token& token, std::string message, std::string hint = {});
  /// "expected X, found Y", with a hint for common slips.
  [[noreturn]] void unexpected(const std::string& expected);

  /// After a fault: goes to the next statement at the top of a file.
  void recover_statement();
  /// After a fault inside { }: goes behind the next line break outside brackets, or to "}".
  void recover_entry();
  /// True at the first token of a line that can only start a statement, e.g. after a lost "}".
  bool at_statement() const;

  /// While it lives, line breaks are invisible.
  class BracketScope {
   public:
    explicit BracketScope(Cursor& cursor) : cursor_(cursor) { ++cursor_.brackets_; }
    ~BracketScope() { --cursor_.brackets_; }
    BracketScope(const BracketScope&) = delete;
    BracketScope& operator=(const BracketScope&) = delete;

   private:
    Cursor& cursor_;
  };

  /// While it lives, an expression ends with its line: the next one may start with any sign.
  class LineScope {
   public:
    explicit LineScope(Cursor& cursor) : cursor_(cursor) { ++cursor_.lines_; }
    ~LineScope() { --cursor_.lines_; }
    LineScope(const LineScope&) = delete;
    LineScope& operator=(const LineScope&) = delete;

   private:
    Cursor& cursor_;
  };

  /// Bounds recursion; fails when too deep.
  class NestingGuard {
   public:
    explicit NestingGuard(Cursor& cursor);
    ~NestingGuard() { --cursor_.nesting_; }
    NestingGuard(const NestingGuard&) = delete;
    NestingGuard& operator=(const NestingGuard&) = delete;

   private:
    Cursor& cursor_;
  };

 private:
  size_t visible(size_t at) const;
  bool first_on_line(size_t at) const;
  bool starts_statement(size_t at) const;

  const std::vector<Token>& tokens_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  const ParseOptions& options_;
  size_t at_ = 0;
  size_t last_ = 0;
  int brackets_ = 0;
  int lines_ = 0;
  int nesting_ = 0;
  int errors_ = 0;
  int faults_ = 0;
};

/// How a token is called in messages: "'+'", "the end of the line", "the number 2cm", ...
std::string describe(const Token& token);

}  // namespace vug::scene
