// SPDX-License-Identifier: Apache-2.0
// Parses the parts of expressions that bind names: comprehensions, parameters of functions,
// `where`.
#include <vug/scene/check.h>
#include <vug/scene/expr_parser.h>
#include <vug/scene/path_scope.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

constexpr size_t kMaxClauses = 64;

}  // namespace

ExprPtr ExprParser::comprehension(const Token& open) {
  Expr expr;
  expr.kind = ExprKind::comprehension;
  const PathScope step(path_, "for");
  expr.path = identity("[]");
  loop_clauses(expr);
  cursor_.expect(":", " before the value of each element");
  const ExprPtr value = binary(1);
  expr.operands.push_back({"", value->extent, value});
  if (cursor_.peek().is(","))
    cursor_.fail(cursor_.peek(), "a list with 'for' has one value for each element",
                 "join lists with concat([for ...: a], [b, c])");
  cursor_.expect("]", fmt::format(" to close '[' of line {}", open.line));
  return finish(std::move(expr), open);
}

void ExprParser::loop_clauses(Expr& comprehension) {
  while (cursor_.peek().is_name("for") || cursor_.peek().is_name("if") ||
         cursor_.peek().is_name("sort")) {
    const Token& word = cursor_.take();
    if (comprehension.operands.size() >= kMaxClauses)
      cursor_.fail(word, fmt::format("more than {} clauses in a loop", kMaxClauses));
    if (!comprehension.operands.empty() && comprehension.operands.back().name == "sort")
      cursor_.fail(word, "'sort by' is the last clause before ':'");
    Operand clause;
    clause.name = std::string(word.text);
    if (word.is_name("for")) bound_names(clause);
    if (word.is_name("sort") && !cursor_.take().is_name("by"))
      cursor_.fail(cursor_.last(),
                   fmt::format("expected 'by' after 'sort', found {}", describe(cursor_.last())));
    loop_clause(std::move(clause), word, comprehension);
  }
}

/// `NAME, NAME in`
void ExprParser::bound_names(Operand& clause) {
  do {
    const Token& name = cursor_.expect_name("the name of a loop variable");
    clause.binds.push_back({std::string(name.text), cursor_.where(name)});
    if (!may_name(clause.binds.back().name))
      cursor_.error(name, fmt::format("'{}' cannot be used as a name", name.text),
                    "it is a unit or a word of the language");
  } while (cursor_.accept(","));
  if (!cursor_.peek().is_name("in"))
    cursor_.unexpected(fmt::format("'in' and a list after '{}'", clause.binds.back().name));
  cursor_.take();
}

void ExprParser::loop_clause(Operand clause, const Token& first, Expr& comprehension) {
  const PathScope step(path_, clause.name);
  clause.value = binary(1);
  clause.where = cursor_.since(first);
  comprehension.operands.push_back(std::move(clause));
}

ExprPtr ExprParser::declared_loop() {
  restart();
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  Expr expr;
  expr.kind = ExprKind::comprehension;
  const PathScope step(path_, "for");
  expr.path = identity("[]");
  const Token& first = cursor_.peek();
  Operand clause;
  clause.name = "for";
  bound_names(clause);
  loop_clause(std::move(clause), first, expr);
  loop_clauses(expr);
  cursor_.expect("]", fmt::format(" to close '[' of line {}", open.line));
  Expr names;  // the value of each element: the list of its variables
  names.kind = ExprKind::list;
  names.extent = cursor_.since(open);
  for (const Operand& each : expr.operands)
    for (const Formal& bound : each.binds) {
      Expr name;
      name.kind = ExprKind::name;
      name.text = bound.name;
      name.extent = bound.where;
      names.operands.push_back({"", bound.where, finish(std::move(name), first)});
    }
  expr.operands.push_back({"", names.extent, finish(std::move(names), open)});
  return finish(std::move(expr), open);
}

std::vector<Formal> ExprParser::formals() {
  std::vector<Formal> all;
  while (!cursor_.peek().is(")")) {
    const Token& name = cursor_.expect_name("the name of a parameter");
    Formal& formal = all.emplace_back();
    formal.name = std::string(name.text);
    formal.where = cursor_.where(name);
    if (cursor_.peek().is(":"))
      cursor_.fail(cursor_.peek(), "expected '=' before the default of a parameter, found ':'",
                   fmt::format("write {} = value", formal.name));
    if (cursor_.accept("=")) {
      restart();
      formal.fallback = binary(1);
    }
    if (cursor_.peek().kind == TokenKind::text) formal.doc = unquote(cursor_.take().text);
    if (!cursor_.accept(",")) break;
  }
  cursor_.expect(")", " after the parameters");
  return all;
}

std::vector<Let> ExprParser::locals() {
  std::vector<Let> all;
  if (!cursor_.beyond_newlines().is_name("where")) return all;
  cursor_.skip_newlines();
  cursor_.take();
  do {
    cursor_.skip_newlines();
    const Token& name = cursor_.expect_name("a name after 'where'");
    Let& local = all.emplace_back();
    local.name = std::string(name.text);
    local.where = cursor_.where(name);
    cursor_.expect("=", fmt::format(" after '{}'", local.name));
    cursor_.skip_newlines();
    local.value = whole();
    local.extent = cursor_.since(name);
  } while (cursor_.accept(","));
  return all;
}

}  // namespace vug::scene
