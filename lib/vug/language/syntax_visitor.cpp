// SPDX-License-Identifier: Apache-2.0
#include <vug/language/syntax_visitor.h>
#include <vug/scene/lsystem_document.h>

namespace vug::language {

void SyntaxVisitor::visit(const scene::ExprPtr& expr) const {
  if (!expr) return;
  if (expression) expression(*expr);
  for (const scene::Operand& part : expr->operands) visit(part.value);
}

void SyntaxVisitor::visit(const std::vector<scene::Entry>& entries) const {
  for (const scene::Entry& each : entries) {
    if (entry) entry(each);
    for (const scene::ExprPtr& value : each.values) visit(value);
  }
}

void SyntaxVisitor::visit(const std::vector<scene::Let>& lets) const {
  for (const scene::Let& let : lets) visit(let.value);
}

void SyntaxVisitor::visit(const std::vector<scene::Item>& items) const {
  for (const scene::Item& item : items) {
    for (const scene::ExprPtr& each : {item.amount, item.shape, item.count}) visit(each);
    visit(item.clauses);
  }
}

void SyntaxVisitor::visit(const scene::Grammar& grammar) const {
  visit(grammar.axiom);
  visit(grammar.options);
  for (const scene::Rule& rule : grammar.rules) {
    visit(rule.weight);
    visit(rule.guard);
    visit(rule.items);
    visit(rule.locals);
  }
  if (!grammar.lsystem) return;
  const auto visit_word = [&](const scene::ModuleString& word) {
    for (const scene::Module& module : word)
      for (const scene::ExprPtr& argument : module.arguments) visit(argument);
  };
  visit_word(grammar.lsystem->axiom);
  for (const scene::ScheduleTurn& turn : grammar.lsystem->schedule) visit(turn.count);
  for (const auto* stage : {&grammar.lsystem->decompose, &grammar.lsystem->interpret})
    visit(stage->depth);
  scene::for_each_production(*grammar.lsystem, [&](const scene::Production& one) {
    for (const scene::ExprPtr& each : {one.weight, one.guard, one.after}) visit(each);
    visit_word(one.word);
    visit(one.locals);
  });
}

void SyntaxVisitor::visit(const scene::Document& document) const {
  visit(document.seed);
  for (const scene::Param& param : document.params)
    for (const scene::ExprPtr& each : {param.value, param.low, param.high, param.given})
      visit(each);
  visit(document.lets);
  for (const scene::Def& def : document.defs) {
    for (const scene::Formal& formal : def.formals) visit(formal.fallback);
    visit(def.body);
    visit(def.locals);
  }
  for (const scene::Declaration& made : document.declarations) {
    for (const scene::ExprPtr& each : {made.value, made.target, made.loop}) visit(each);
    for (const scene::ExprPtr& each : made.more_targets) visit(each);
    visit(made.entries);
  }
  for (const scene::Grammar& grammar : document.grammars) visit(grammar);
}

const scene::Expr* call_around(const scene::Document& document, const SourceLocation& at) {
  const scene::Expr* found = nullptr;
  SyntaxVisitor visitor;
  visitor.expression = [&](const scene::Expr& expr) {
    if (expr.kind != scene::ExprKind::call || expr.where.file != at.file ||
        !expr.where.contains(at))
      return;
    if (!found || found->where.contains(expr.where)) found = &expr;
  };
  visitor.visit(document);
  return found;
}

}  // namespace vug::language
