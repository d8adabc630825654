// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/scene/expr_parser.h>
#include <vug/scene/path_scope.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vug::scene {

namespace {

/// Operator precedence, lowest first; signs, powers and "not" are handled in `prefix`.
constexpr int kCompare = 3, kRange = 4, kAdd = 5;

int precedence(const Token& token) {
  if (token.kind == TokenKind::name) return token.text == "or" ? 1 : token.text == "and" ? 2 : 0;
  if (token.kind != TokenKind::sign) return 0;
  const std::string_view s = token.text;
  if (s == "<" || s == "<=" || s == ">" || s == ">=" || s == "==" || s == "!=") return kCompare;
  if (s == "..") return kRange;
  if (s == "+" || s == "-") return kAdd;
  if (s == "&") return 6;
  return s == "*" || s == "/" ? 7 : 0;
}

bool is_operator_word(const Token& token) {
  return token.is_name("and") || token.is_name("or") || token.is_name("not");
}

Expr make_expr(ExprKind kind, std::string text = {}) {
  Expr expr;
  expr.kind = kind;
  expr.text = std::move(text);
  return expr;
}

}  // namespace

bool ExprParser::starts(const Token& token) {
  switch (token.kind) {
    case TokenKind::number:
    case TokenKind::size:
    case TokenKind::text:
      return true;
    case TokenKind::name:
      return token.text != "and" && token.text != "or";
    default:
      return token.is("(") || token.is("[") || token.is("-") || token.is("+");
  }
}

void ExprParser::restart() {
  path_.clear();
  seen_.clear();
}

ExprPtr ExprParser::whole() {
  restart();
  return binary(1);
}

ExprPtr ExprParser::tight() {
  restart();
  const Token& first = cursor_.peek();
  const ExprPtr low = prefix();
  if (!cursor_.accept("..")) return low;
  Expr range = make_expr(ExprKind::range);
  const ExprPtr high = prefix();
  range.operands = {{"", low->where, low}, {"", high->where, high}};
  range.path = identity("..");
  return finish(std::move(range), first);
}

ExprPtr ExprParser::shape() {
  restart();
  return postfix();
}

void ExprParser::bounds(ExprPtr& low, ExprPtr& high) {
  restart();
  low = binary(kAdd);
  if (!cursor_.accept("..")) cursor_.unexpected("'..' between the ends of the range");
  high = binary(kAdd);
}

const Token& ExprParser::operator_ahead() const {
  // A line that continues an expression can only start with an operator or a method.
  const Token& here = cursor_.peek();
  const Token& beyond = cursor_.beyond_newlines();
  return here.kind == TokenKind::newline && (precedence(beyond) > 0 || beyond.is(".")) ? beyond
                                                                                       : here;
}

ExprPtr ExprParser::binary(int least) {
  const Cursor::NestingGuard nest(cursor_);
  const Token& first = cursor_.peek();
  ExprPtr left = prefix();
  for (;;) {
    const int level = precedence(operator_ahead());
    if (level == 0 || level < least) return left;
    cursor_.skip_newlines();
    const Token& sign = cursor_.take();
    cursor_.skip_newlines();
    const ExprPtr right = binary(level + 1);
    Expr expr = make_expr(level == kRange ? ExprKind::range : ExprKind::binary);
    if (level != kRange) expr.text = std::string(sign.text);
    expr.operands = {{"", left->where, left}, {"", right->where, right}};
    if (level == kRange) expr.path = identity("..");
    left = finish(std::move(expr), first);
    if ((level == kCompare || level == kRange) && precedence(operator_ahead()) == level)
      cursor_.fail(operator_ahead(),
                   level == kRange ? "a range has two ends" : "comparisons cannot be chained",
                   level == kRange ? "" : "write a < b and b < c");
  }
}

ExprPtr ExprParser::prefix() {
  const Token& token = cursor_.peek();
  if (!token.is("-") && !token.is("+") && !token.is_name("not")) {
    ExprPtr base = postfix();
    if (!cursor_.peek().is("^")) return base;
    Expr power = make_expr(ExprKind::binary, std::string(cursor_.take().text));
    cursor_.skip_newlines();
    const Cursor::NestingGuard nest(cursor_);
    const ExprPtr exponent = prefix();
    power.operands = {{"", base->where, base}, {"", exponent->where, exponent}};
    return finish(std::move(power), token);
  }
  cursor_.take();
  const Cursor::NestingGuard nest(cursor_);
  Expr expr = make_expr(ExprKind::unary, std::string(token.text));
  // "not a < b" negates the comparison; "-a ^ 2" is -(a ^ 2).
  const ExprPtr inner = expr.text == "not" ? binary(kCompare) : prefix();
  expr.operands = {{"", inner->where, inner}};
  return finish(std::move(expr), token);
}

ExprPtr ExprParser::postfix() {
  const Token& first = cursor_.peek();
  ExprPtr expr = primary();
  for (;;) {
    if (cursor_.peek().is("[") && cursor_.peek().touches) {
      expr = index(expr, first);
      continue;
    }
    if (!operator_ahead().is(".")) return expr;
    cursor_.skip_newlines();
    cursor_.take();
    const Token& name =
        cursor_.expect_name("the name of a method or of a module's member after '.'");
    const bool called = cursor_.peek().is("(") && cursor_.peek().touches;
    if (expr->kind == ExprKind::name && name.text[0] == '_')
      cursor_.fail(name, fmt::format("'{}' is private to the file of '{}'", name.text, expr->text),
                   "names that begin with '_' can only be used in the file that declares them");
    if (called) {
      expr = call(name, expr, first);
    } else if (expr->kind == ExprKind::name) {
      expr = finish(make_expr(ExprKind::name, fmt::format("{}.{}", expr->text, name.text)), first);
    } else {
      cursor_.unexpected(fmt::format("'(' after '.{}'", name.text));
    }
  }
}

ExprPtr ExprParser::primary() {
  const Token& token = cursor_.peek();
  if (token.is("(")) return bracketed();
  if (token.is("[")) return list();
  if (!starts(token) || token.kind == TokenKind::sign) cursor_.unexpected("a value");
  cursor_.take();
  Expr expr = make_expr(ExprKind::name, std::string(token.text));
  if (token.kind == TokenKind::number) {
    expr.kind = ExprKind::number;
    expr.number = token.number;
    expr.text.clear();
  } else if (token.kind == TokenKind::text) {
    expr.kind = ExprKind::text;
    expr.text = unquote(token.text);
  } else if (token.kind == TokenKind::size) {
    expr.kind = ExprKind::list;
    expr.text.clear();
    const size_t cross = token.text.find('x');
    SourceLocation where = cursor_.where(token);
    for (const std::string_view part :
         {token.text.substr(0, cross), token.text.substr(cross + 1)}) {
      Expr side = make_expr(ExprKind::number);
      side.extent = where = word_at(where, std::string(part));
      where.column = where.end_column + 1;
      std::from_chars(part.data(), part.data() + part.size(), side.number.value);
      expr.operands.push_back({"", side.extent, finish(std::move(side), token)});
    }
  } else if (is_operator_word(token)) {
    cursor_.fail(token, fmt::format("expected a value, found '{}'", token.text));
  } else if (cursor_.peek().is("(") && cursor_.peek().touches) {
    return call(token, nullptr, token);
  } else if (token.is_name("by") && cursor_.peek().is_name("rock") && cursor_.peek(1).is("{")) {
    return by_rock(token);
  } else if (token.text == "true" || token.text == "false") {
    expr.kind = ExprKind::truth;
  } else if (token.text == "if") {
    cursor_.fail(token, "'if' needs three values here: if(condition, then, else)");
  }
  return finish(std::move(expr), token);
}

ExprPtr ExprParser::bracketed() {
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  Expr vector = make_expr(ExprKind::vector);
  do {
    if (!vector.operands.empty() && cursor_.peek().is(")")) break;  // a trailing comma
    const ExprPtr part = binary(1);
    vector.operands.push_back({"", part->where, part});
  } while (cursor_.accept(","));
  cursor_.expect(")", fmt::format(" to close '(' of line {}", open.line));
  if (vector.operands.size() == 1) return vector.operands[0].value;
  if (vector.operands.size() > 3)
    cursor_.error(cursor_.since(open),
                  fmt::format("a vector with {} components", vector.operands.size()),
                  "a vector has 2 or 3; write a list as [a, b, c, d]");
  return finish(std::move(vector), open);
}

ExprPtr ExprParser::list() {
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  if (cursor_.peek().is_name("for") && cursor_.peek(1).kind == TokenKind::name)
    return comprehension(open);
  Expr expr = make_expr(ExprKind::list);
  while (!cursor_.peek().is("]")) {
    if (cursor_.peek().is_name("for") && cursor_.peek(1).kind == TokenKind::name)
      cursor_.fail(cursor_.peek(), "a list with 'for' contains nothing before 'for'",
                   "join lists with concat([a, b], [for ...: c])");
    const ExprPtr part = binary(1);
    expr.operands.push_back({"", part->where, part});
    if (!cursor_.accept(",")) break;
  }
  cursor_.expect("]", fmt::format(" to close '[' of line {}", open.line));
  return finish(std::move(expr), open);
}

/// `base[index]`; the bracket touches the base.
ExprPtr ExprParser::index(ExprPtr base, const Token& first) {
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  const Cursor::NestingGuard nest(cursor_);
  Expr expr = make_expr(ExprKind::index);
  expr.operands.push_back({"", base->where, base});
  if (cursor_.peek().is("]")) cursor_.unexpected("an index, counted from 0");
  const ExprPtr number = binary(1);
  expr.operands.push_back({"", number->where, number});
  cursor_.expect("]", fmt::format(" to close '[' of line {}", open.line));
  return finish(std::move(expr), first);
}

ExprPtr ExprParser::call(const Token& name, ExprPtr receiver, const Token& first) {
  Expr expr = make_expr(ExprKind::call, std::string(name.text));
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  if (receiver) {
    expr.method = true;
    expr.operands.push_back({"", receiver->where, receiver});
  }
  const PathScope step(path_, expr.text);
  expr.path = identity("()");
  bool named = false;
  while (!cursor_.peek().is(")")) {
    operand(expr, named);
    if (!cursor_.accept(",")) break;
  }
  cursor_.expect(")", fmt::format(" to close '{}(' of line {}", name.text, open.line));
  expr.where = cursor_.since(name);
  return finish(std::move(expr), first);
}

void ExprParser::operand(Expr& call, bool& named) {
  const Token& first = cursor_.peek();
  Operand result;
  const size_t sign = first.is("-") ? 1 : 0;
  const Token& word = cursor_.peek(sign);
  if (word.kind == TokenKind::number && cursor_.peek(sign + 1).is(":")) {  // a frame
    if (word.number.dimension != Dimension::none)
      cursor_.error(word, "a key must be a frame number without a unit", "keys(1: 0m, 24: 2m)");
    named = true;
    result.name = fmt::format("{}", sign ? -word.number.value : word.number.value);
    for (size_t i = 0; i < sign + 2; ++i) cursor_.take();
  } else if (first.kind == TokenKind::name && cursor_.peek(1).is(":")) {
    named = true;
    result.name = std::string(first.text);
    cursor_.take();
    cursor_.take();
  } else if (first.kind == TokenKind::name && cursor_.peek(1).is("=")) {
    cursor_.fail(cursor_.peek(1), "expected ':' after the name of an argument, found '='",
                 fmt::format("write {}: value", first.text));
  } else if (named) {
    cursor_.error(first, "a positional argument follows a named one",
                  "put it first, or name it, too");
  }
  const size_t index = call.operands.size();
  const PathScope step(path_, result.name.empty() ? fmt::format("{}", index) : result.name);
  result.value = binary(1);
  result.where = cursor_.since(first);
  call.operands.push_back(std::move(result));
}

/// The expression that starts at `first` and ends at the last consumed token.
ExprPtr ExprParser::finish(Expr expr, const Token& first) {
  if (expr.kind == ExprKind::name || expr.kind == ExprKind::call) expr.module = cursor_.module();
  if (!expr.extent.known()) expr.extent = cursor_.since(first);
  if (!expr.where.known()) expr.where = expr.extent;
  for (const Operand& part : expr.operands)
    expr.depth = std::max(expr.depth, 1 + part.value->depth);
  if (expr.depth > cursor_.options().max_depth)
    cursor_.fail(cursor_.last(),
                 fmt::format("an expression with more than {} levels", cursor_.options().max_depth),
                 "use 'let' to name a part of it");
  return std::make_shared<const Expr>(std::move(expr));
}

uint64_t ExprParser::identity(const std::string& path) {
  const std::string full = path_ + path;
  return RandomKey(0).at(full).at(seen_[full]++).state();
}

}  // namespace vug::scene
