// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/scene/cursor.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::scene {

namespace {

bool is_line_break(const Token& token) {
  return token.kind == TokenKind::newline && token.text != ";";
}

std::string shortened(std::string_view text) {
  size_t length = std::min<size_t>(text.size(), 40);
  while (length < text.size() && length > 0 && is_utf8_tail(text[length])) --length;
  return printable(text.substr(0, length)) + (length < text.size() ? "..." : "");
}

}  // namespace

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::end:
      return "the end of the text";
    case TokenKind::newline:
      return token.text == ";" ? "';'" : "the end of the line";
    case TokenKind::number:
      return fmt::format("the number {}", shortened(token.text));
    case TokenKind::size:
      return fmt::format("the size {}", shortened(token.text));
    case TokenKind::text:
      return fmt::format("the text {}", shortened(token.text));
    case TokenKind::junk:
      return "an invalid character";
    default:
      return fmt::format("'{}'", shortened(token.text));
  }
}

size_t Cursor::visible(size_t at) const {
  if (brackets_ > 0)
    while (is_line_break(tokens_[at])) ++at;
  return at;
}

const Token& Cursor::peek(size_t ahead) const {
  if (brackets_ == 0) return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  size_t at = visible(at_);
  for (; ahead > 0 && tokens_[at].kind != TokenKind::end; --ahead) at = visible(at + 1);
  return tokens_[at];
}

const Token& Cursor::take() {
  last_ = visible(at_);
  at_ = tokens_[last_].kind == TokenKind::end ? last_ : last_ + 1;
  if (tokens_[last_].faulty) ++faults_;
  return tokens_[last_];
}

SourceLocation Cursor::since(const Token& first) const {
  size_t last = last_;
  while (last > 0 && is_line_break(tokens_[last])) --last;
  return where(first).up_to(where(*std::max(&first, &tokens_[last])));
}

bool Cursor::accept(std::string_view sign) {
  if (!peek().is(sign)) return false;
  take();
  return true;
}

bool Cursor::at_line_end() const {
  const Token& token = peek();
  return token.kind == TokenKind::newline || token.kind == TokenKind::end || token.is("}");
}

void Cursor::expect(std::string_view sign, const std::string& purpose) {
  if (!accept(sign)) unexpected(fmt::format("'{}'{}", sign, purpose));
}

const Token& Cursor::expect_name(const std::string& what) {
  if (peek().kind != TokenKind::name) unexpected(what);
  return take();
}

void Cursor::skip_newlines() {
  size_t at = at_;
  while (is_line_break(tokens_[at])) ++at;
  if (at != at_ &&
      (tokens_[at].is("}") || tokens_[at].kind == TokenKind::end || starts_statement(at)))
    return;
  at_ = at;
}

const Token& Cursor::beyond_newlines() const {
  if (lines_ > 0 && brackets_ == 0) return tokens_[at_];
  size_t at = at_;
  while (is_line_break(tokens_[at])) ++at;
  return tokens_[at];
}

bool Cursor::accept_beyond_newlines(std::string_view sign) {
  if (!beyond_newlines().is(sign)) return false;
  skip_newlines();
  take();
  return true;
}

void Cursor::error(const Token& token, std::string message, std::string hint) {
  // A junk token was already reported by the lexer; a further error would not help.
  if (token.kind == TokenKind::junk && diagnostics_.has_errors())
    ++faults_;
  else
    error(where(token), std::move(message), std::move(hint));
}

void Cursor::error(const SourceLocation& where, std::string message, std::string hint) {
  ++faults_;
  if (errors_++ < options_.max_errors)
    diagnostics_.error(where, std::move(message), std::move(hint));
}

void Cursor::fail(const Token& token, std::string message, std::string hint) {
  error(token, std::move(message), std::move(hint));
  throw SyntaxFault{};
}

void Cursor::unexpected(const std::string& expected) {
  const Token& found = peek();
  const Token& before = tokens_[last_];
  std::string hint;
  if (found.is("(") && before.kind == TokenKind::name && !found.touches)
    hint =
        fmt::format("write the parenthesis directly after the name: '{}('", shortened(before.text));
  else if (found.kind == TokenKind::name && before.kind == TokenKind::number && is_unit(found.text))
    hint = fmt::format("write the unit directly after the number: {}{}", before.text, found.text);
  else if (found.is("=") && brackets_ > 0)
    hint = "compare with '=='";
  else if (found.is("~"))
    hint = "'~' is only allowed before an item of a rule; the complement of a is -a";
  fail(found, fmt::format("expected {}, found {}", expected, describe(found)), std::move(hint));
}

void Cursor::add_names_since(size_t position, std::set<std::string>& names) const {
  for (size_t at = position; at < at_; ++at)
    if (tokens_[at].kind == TokenKind::name) names.emplace(tokens_[at].text);
}

bool Cursor::first_on_line(size_t at) const {
  return at == 0 || tokens_[at - 1].kind == TokenKind::newline;
}

bool Cursor::at_statement() const { return starts_statement(at_); }

bool Cursor::starts_statement(size_t at) const {
  if (tokens_[at].kind != TokenKind::name || !first_on_line(at)) return false;
  const auto kind = [&](size_t ahead) {
    return at + ahead < tokens_.size() ? tokens_[at + ahead].kind : TokenKind::end;
  };
  if (tokens_[at].is_name("include") && kind(1) == TokenKind::text) return true;
  if (kind(1) != TokenKind::name || kind(2) == TokenKind::end || tokens_[at].is_name("where"))
    return false;
  const Token& third = tokens_[at + 2];
  if (third.is("(") && tokens_[at].is_name("def")) return true;
  if (third.is("[") && third.touches && kind(3) == TokenKind::name && kind(4) != TokenKind::end &&
      (tokens_[at + 4].is_name("in") || tokens_[at + 4].is(",")))
    return true;
  if (third.is_name("on") && kind(3) == TokenKind::name) return true;
  return third.is("=") || third.is("{") ||
         (third.is(":") && tokens_[at].is_name("grammar") && kind(3) == TokenKind::name);
}

void Cursor::recover_statement(size_t start) {
  brackets_ = 0;
  const int column = tokens_[start].column;
  // Inside a bracket that is never closed, the next statement has been read as values.
  for (size_t at = start + 1; at <= last_; ++at)
    if (starts_statement(at) && tokens_[at].column <= column) {
      at_ = at;
      return;
    }
  int braces = 0;
  // The faulty token itself may be the start of the next statement.
  for (; tokens_[at_].kind != TokenKind::end; ++at_) {
    const Token& token = tokens_[at_];
    if (at_ > last_ && at_statement()) return;
    if (token.is("{")) ++braces;
    if (token.is("}") && --braces <= 0) {
      ++at_;
      return;
    }
    const bool ends = is_line_break(token) && braces == 0 && !tokens_[at_ + 1].is("{");
    if (token.text == ";" && token.kind == TokenKind::newline && braces == 0) return;
    if (ends && tokens_[at_ + 1].column <= column) return;
  }
}

void Cursor::recover_entry() {
  brackets_ = 0;
  int depth = 0, braces = 0;
  for (; tokens_[at_].kind != TokenKind::end; ++at_) {
    const Token& token = tokens_[at_];
    if ((token.is("}") && braces == 0) || (at_ > last_ && at_statement())) return;
    if (token.is("(") || token.is("[")) ++depth;
    if ((token.is(")") || token.is("]")) && depth > 0) --depth;
    if (token.is("{")) ++braces;
    if (token.is("}")) --braces;
    if (token.kind == TokenKind::newline && depth == 0 && braces == 0) return;
  }
}

Cursor::NestingGuard::NestingGuard(Cursor& cursor) : cursor_(cursor) {
  if (++cursor_.nesting_ <= cursor_.options_.max_nesting) return;
  --cursor_.nesting_;  // the destructor of a throwing constructor does not run
  cursor_.fail(cursor_.peek(),
               fmt::format("more than {} levels of nesting", cursor_.options_.max_nesting),
               "use 'let' to name a part of it");
}

}  // namespace vug::scene
