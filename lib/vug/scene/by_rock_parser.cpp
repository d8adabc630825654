// SPDX-License-Identifier: Apache-2.0
// Parses `by rock { NAME -> MATERIAL ... }`.
#include <vug/scene/expr_parser.h>
#include <vug/scene/path_scope.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

Expr list_at(const SourceLocation& where) {
  Expr list;
  list.kind = ExprKind::list;
  list.where = where;
  return list;
}

}  // namespace

/// The table becomes the call by_rock(of: [NAMES], materials: [...], otherwise: ...), so the rest
/// of the language needs no rule of its own for it.
ExprPtr ExprParser::by_rock(const Token& by) {
  cursor_.take();  // rock
  const Token& open = cursor_.take();
  const Cursor::BracketScope brackets(cursor_);
  const Cursor::NestingGuard nest(cursor_);
  const PathScope step(path_, "by_rock");
  Expr call;
  call.kind = ExprKind::call;
  call.text = "by_rock";
  call.path = identity("()");
  Expr names = list_at(cursor_.since(by)), materials = names;
  Operand otherwise{"otherwise", {}, nullptr};
  while (!cursor_.peek().is("}")) {
    const Token& rock = cursor_.peek();
    if (rock.kind != TokenKind::name && rock.kind != TokenKind::text)
      cursor_.unexpected(fmt::format("a rock or '}}' to close '{{' of line {}", open.line));
    cursor_.take();
    cursor_.expect("->", fmt::format(" and a material after the rock {}", rock.text));
    const PathScope name(path_, rock.text);
    const ExprPtr material = binary(1);
    cursor_.accept(",");
    if (rock.is_name("otherwise")) {
      if (otherwise.value) cursor_.error(rock, "a second 'otherwise'", "keep one of them");
      otherwise.where = cursor_.since(rock);
      otherwise.value = material;
      continue;
    }
    Expr named;
    named.kind = ExprKind::text;
    named.text = rock.kind == TokenKind::text ? unquote(rock.text) : std::string(rock.text);
    named.extent = named.where = cursor_.where(rock);
    for (const Operand& earlier : names.operands)
      if (earlier.value->text == named.text)
        cursor_.error(rock, fmt::format("a second material for the rock '{}'", named.text),
                      fmt::format("the first is at {}", to_string(earlier.where)));
    names.operands.push_back({"", named.where, finish(std::move(named), rock)});
    materials.operands.push_back({"", material->where, material});
  }
  cursor_.expect("}", "");
  if (names.operands.empty() && otherwise.value)
    cursor_.fail(by, "'by rock' has only the row 'otherwise'",
                 "give its material without a table, or add a row such as limestone -> lambert()");
  if (names.operands.empty())
    cursor_.fail(by, "'by rock' without a rock", "by rock { limestone -> lambert() }");
  call.where = cursor_.since(by);
  for (Expr* list : {&names, &materials}) list->extent = call.where;
  call.operands.push_back({"of", call.where, finish(std::move(names), by)});
  call.operands.push_back({"materials", call.where, finish(std::move(materials), by)});
  if (otherwise.value) call.operands.push_back(std::move(otherwise));
  return finish(std::move(call), by);
}

}  // namespace vug::scene
