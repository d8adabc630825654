// SPDX-License-Identifier: Apache-2.0
// The parser's position in the tokens of one file, errors of the form "expected X, found Y", and
// error recovery.
#pragma once

#include <vug/scene/lexer.h>
#include <vug/scene/parser.h>

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::scene {

/// Thrown after a syntax error was reported; caught where parsing can continue.
struct SyntaxFault {};

class Cursor {
 public:
  /// All arguments must outlive the cursor; `tokens` ends with an end token.
  Cursor(const std::vector<Token>& tokens, const std::string& file, Diagnostics& diagnostics,
         const ParseOptions& options, std::shared_ptr<const std::string> module = nullptr)
      : tokens_(tokens),
        file_(file),
        diagnostics_(diagnostics),
        options_(options),
        module_(std::move(module)) {}

  /// The token `ahead` positions from here; line breaks are skipped inside ( ) or [ ].
  const Token& peek(size_t ahead = 0) const;
  /// The last consumed token; initially the first token.
  const Token& last() const { return tokens_[last_]; }
  const Token& take();
  bool accept(std::string_view sign);
  bool at_end() const { return peek().kind == TokenKind::end; }
  /// True at a line break, ";", "}" or the end.
  bool at_line_end() const;

  /// Consumes `sign` or fails; `purpose` describes it in the message.
  void expect(std::string_view sign, const std::string& purpose);
  /// Consumes a name or fails with "expected `what`, found ...".
  const Token& expect_name(const std::string& what);
  /// Consumes line breaks except those before a new statement, a "}" or the end.
  void skip_newlines();
  /// The token after any line breaks (not ";"), without consuming them.
  const Token& beyond_newlines() const;
  /// If the first token after any line breaks is `sign`, consumes the line breaks and the sign.
  bool accept_beyond_newlines(std::string_view sign);

  SourceLocation where(const Token& token) const {
    return {file_, token.line, token.column, token.end_line(), token.end_column()};
  }
  /// From `first` to the last consumed token that is not a line break.
  SourceLocation since(const Token& first) const;
  const std::string& file() const { return file_; }
  /// The prefix of the names that the file declares (see Expr::module); null: none.
  const std::shared_ptr<const std::string>& module() const { return module_; }
  /// The name of a declaration, with this prefix.
  std::string declared_name(const Token& name) const {
    return (module_ ? *module_ : std::string()) + std::string(name.text);
  }
  const ParseOptions& options() const { return options_; }
  Diagnostics& diagnostics() const { return diagnostics_; }

  /// The number of faults so far: consumed faulty tokens and errors, reported or dropped.
  int faults() const { return faults_; }
  /// The index of the next token.
  size_t position() const { return at_; }
  /// Adds the names among the tokens since an index.
  void add_names_since(size_t position, std::set<std::string>& names) const;

  /// Reports an error at a token or a range and returns.
  void error(const Token& token, std::string message, std::string hint = {});
  void error(const SourceLocation& where, std::string message, std::string hint = {});
  /// Reports an error at a token and throws SyntaxFault.
  [[noreturn]] void fail(const Token& token, std::string message, std::string hint = {});
  /// Fails with "expected X, found Y" and a hint for common mistakes.
  [[noreturn]] void unexpected(const std::string& expected);

  /// After an error in the statement whose first token has this index: moves to the next one. Lines
  /// that begin further right continue the faulty statement.
  void recover_statement(size_t start);
  /// After an error inside { }: skips past the next line break outside brackets, or to "}".
  void recover_entry();
  /// True at the first token of a line that can only start a statement, e.g. after a lost "}".
  bool at_statement() const;

  /// Line breaks are skipped during its lifetime.
  class BracketScope {
   public:
    explicit BracketScope(Cursor& cursor) : cursor_(cursor) { ++cursor_.brackets_; }
    ~BracketScope() { --cursor_.brackets_; }
    BracketScope(const BracketScope&) = delete;
    BracketScope& operator=(const BracketScope&) = delete;

   private:
    Cursor& cursor_;
  };

  /// During its lifetime an expression ends with its line: the next line may start with any sign.
  class LineScope {
   public:
    explicit LineScope(Cursor& cursor) : cursor_(cursor) { ++cursor_.lines_; }
    ~LineScope() { --cursor_.lines_; }
    LineScope(const LineScope&) = delete;
    LineScope& operator=(const LineScope&) = delete;

   private:
    Cursor& cursor_;
  };

  /// Limits the nesting depth; fails beyond it.
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
  std::shared_ptr<const std::string> module_;
  size_t at_ = 0;
  size_t last_ = 0;
  int brackets_ = 0;
  int lines_ = 0;
  int nesting_ = 0;
  int errors_ = 0;
  int faults_ = 0;
};

/// The description of a token in messages: "'+'", "the end of the line", "the number 2cm", ...
std::string describe(const Token& token);

}  // namespace vug::scene
