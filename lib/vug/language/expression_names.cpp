// SPDX-License-Identifier: Apache-2.0
// The names in expressions, in the order of scene/evaluate.cpp (Evaluator::name).
#include <vug/language/kinds.h>
#include <vug/language/symbol_collector.h>
#include <vug/scene/units.h>

namespace vug::language {
namespace {

using scene::Expr;
using scene::ExprKind;

/// The parameter of a call's operand, of the first kind of that name that has one.
const ParamInfo* param_of(const Expr& call, size_t position, const std::string& name,
                          std::string_view expected) {
  const ParamInfo* first = nullptr;
  for (const CallableKind& kind : callable_kinds(call.text)) {
    const ParamInfo* param = find_param(*kind.info, position, name);
    if (param && kind.type == expected) return param;
    if (param && !first) first = param;
  }
  return first;
}

SourceLocation last_word(const SourceLocation& where, const std::string& word) {
  SourceLocation last = where;
  if (where.line == where.end_line) last.column = where.end_column - static_cast<int>(word.size());
  return last;
}

}  // namespace

void SymbolCollector::expr(const scene::ExprPtr& expr, std::string_view expected) {
  if (!expr) return;
  switch (expr->kind) {
    case ExprKind::name:
      return name(*expr, expected);
    case ExprKind::call:
      return call(*expr, expected);
    case ExprKind::comprehension:
      return comprehension(*expr, expected);
    default:
      break;
  }
  const bool parts = expr->kind == ExprKind::list || expr->kind == ExprKind::vector;
  for (const scene::Operand& part : expr->operands)
    this->expr(part.value, parts ? element_type(expected) : std::string_view());
}

void SymbolCollector::call(const Expr& call, std::string_view expected) {
  const SourceLocation word = scene::word_at(call.where, call.text);
  std::string full = scene::full_name(call);
  if (call.method && call.operands[0].value->kind == ExprKind::name) {
    const std::string module = scene::full_name(*call.operands[0].value);
    if (modules_.count(module)) full = module + "." + call.text;
  }
  if (const auto function = functions_.find(full); function != functions_.end())
    refer(word, function->second);
  else if (heads_are_values_)
    symbol_of_rule(call);
  for (size_t i = 0; i < call.operands.size(); ++i) {
    const scene::Operand& part = call.operands[i];
    const ParamInfo* param = param_of(call, i, part.name, expected);
    if (param && part.value->kind == ExprKind::name && has_choice(*param, part.value->text))
      continue;
    expr(part.value, param ? element_type(param->type) : std::string_view());
  }
}

void SymbolCollector::comprehension(const Expr& loop, std::string_view expected) {
  const LocalScope scope(locals_);
  for (const scene::Operand& part : loop.operands) {
    expr(part.value, part.name.empty() ? element_type(expected) : std::string_view());
    for (const scene::Formal& bound : part.binds)
      add_local(SymbolKind::variable, bound, loop.extent);
  }
}

void SymbolCollector::name(const Expr& name, std::string_view expected) {
  for (auto local = locals_.rbegin(); local != locals_.rend(); ++local)
    if (local->first == name.text) return refer(name.extent, local->second);
  if (heads_are_values_ && symbol_of_rule(name)) return;
  const std::string full = scene::full_name(name);
  // The name of a module before its member, or alone before the call of a function.
  const size_t dot = name.text.rfind('.');
  const std::string module = dot == std::string::npos ? full : full.substr(0, full.rfind('.'));
  if (const auto known = modules_.find(module); known != modules_.end()) {
    const Symbol& symbol = table_.symbols[static_cast<size_t>(known->second)];
    refer(scene::word_at(name.extent, symbol.name), known->second);
    if (dot == std::string::npos) return;
  }
  const SourceLocation where =
      dot == std::string::npos ? name.extent : last_word(name.extent, name.text.substr(dot + 1));
  if (!expected.empty())
    if (const int made = find_declared(full, expected, name.extent); made >= 0)
      return refer(where, made);
  if (const auto known = globals_.find(full); known != globals_.end())
    return refer(where, known->second);
  if (scene::is_unit(name.text)) return;
  if (const int made = find_declared(full, {}, name.extent); made >= 0) refer(where, made);
}

/// The declaration of the type, or (empty) the first one outside of which the name is written.
int SymbolCollector::find_declared(const std::string& full, std::string_view type,
                                   const SourceLocation& from) const {
  const auto all = declared_.find(full);
  if (all == declared_.end()) return -1;
  for (const int index : all->second) {
    const Symbol& symbol = table_.symbols[static_cast<size_t>(index)];
    if (type.empty() ? !symbol.extent.contains(from) : symbol.keyword == type) return index;
  }
  return type.empty() ? all->second.front() : -1;
}

}  // namespace vug::language
