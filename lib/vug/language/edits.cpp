// SPDX-License-Identifier: Apache-2.0
#include <vug/language/context.h>
#include <vug/language/edits.h>
#include <vug/language/kinds.h>
#include <vug/language/syntax_visitor.h>
#include <vug/scene/evaluator.h>

#include <fmt/format.h>

namespace vug::language {
namespace {

/// The range of several values after each other.
SourceLocation range_of(const std::vector<scene::ExprPtr>& values) {
  return values.front()->extent.up_to(values.back()->extent);
}

bool is_broken(const scene::ExprPtr& value) {
  return !value || value->kind == scene::ExprKind::broken;
}

/// The operand for a parameter: by its name, or by its position.
const scene::Operand* find_operand(const scene::Expr& call, const scene::Document& document,
                                   const std::string& name) {
  for (const scene::Operand& each : call.operands)
    if (each.name == name) return &each;
  const auto at_position = [&](const KindInfo& info) -> const scene::Operand* {
    for (size_t i = 0; i < call.operands.size() && i < info.params.size(); ++i)
      if (call.operands[i].name.empty() && info.params[i].name == name) return &call.operands[i];
    return nullptr;
  };
  for (const scene::Def& def : document.defs)
    if (def.name == call.text) return at_position(scene::info_of(def));
  for (const CallableKind& kind : callable_kinds(call.text))
    if (const scene::Operand* found = at_position(*kind.info)) return found;
  return nullptr;
}

/// The position before the last token of a range, which closes it.
Position before_closing(const Analysis& analysis, const SourceLocation& range) {
  const int index = token_at(analysis.tokens, end_of(range));
  const scene::Token& token = analysis.tokens.at(static_cast<size_t>(index));
  return {token.line, token.column};
}

/// The end of the last token before a position, comments excluded.
Position end_before(const Analysis& analysis, const Position& position) {
  Position end{1, 1};
  for (const scene::Token& token : analysis.tokens) {
    if (Position{token.line, token.column} >= position) break;
    if (token.kind != scene::TokenKind::comment && token.kind != scene::TokenKind::newline)
      end = {token.end_line(), token.end_column()};
  }
  return end;
}

}  // namespace

TextEdit set_param(const Analysis& analysis, const std::string& name, const std::string& value) {
  const scene::Param* param = analysis.document.find_param(name);
  if (!param || param->where.file != analysis.file)
    throw Error(ErrorCode::bad_input, fmt::format("the text has no param '{}'", name), {},
                "name a param that is declared in this file");
  if (is_broken(param->value))
    throw Error(ErrorCode::bad_input, fmt::format("the param '{}' has a syntax error", name),
                param->where, "correct it first");
  return {param->value->extent, value};
}

TextEdit set_argument(const Analysis& analysis, const Position& position, const std::string& name,
                      const std::string& value) {
  const scene::Expr* call = call_around(analysis.document, range_at(analysis.file, position));
  if (!call)
    throw Error(ErrorCode::bad_input, "no call is written here", range_at(analysis.file, position),
                "move into a call without syntax errors");
  if (const scene::Operand* known = find_operand(*call, analysis.document, name))
    return {known->value->extent, value};
  const Position close = before_closing(analysis, call->where);
  const Position last = end_before(analysis, close);
  const bool empty = call->operands.size() == (call->method ? 1u : 0u);
  return {range_at(analysis.file, last), fmt::format("{}{}: {}", empty ? "" : ", ", name, value)};
}

TextEdit set_entry(const Analysis& analysis, const std::string& keyword, const std::string& name,
                   const std::string& key, const std::string& value) {
  const scene::Declaration* made = analysis.document.find(name, keyword);
  if (!made || made->value || made->where.file != analysis.file || made->incomplete)
    throw Error(ErrorCode::bad_input,
                fmt::format("the text has no block of {} '{}'", keyword, name), {},
                "name a declaration with { } and without syntax errors");
  if (const scene::Entry* known = made->find_entry(key)) return {range_of(known->values), value};
  const Position close = before_closing(analysis, made->extent);
  const Position last = end_before(analysis, close);
  const std::string entry = key + " " + value;
  if (close.line == made->where.line)
    return {range_at(analysis.file, last), (made->entries.empty() ? " " : "  ") + entry};
  const SourceLocation at = range_at(analysis.file, {close.line, 1});
  const int indent =
      made->entries.empty() ? made->kind_where.column + 2 : made->entries[0].where.column;
  return {at, std::string(static_cast<size_t>(indent - 1), ' ') + entry + "\n"};
}

}  // namespace vug::language
