// SPDX-License-Identifier: Apache-2.0
// Visits the ranges of a document; shared by unit tests and fuzz targets.
#pragma once

#include <vug/scene/lsystem_document.h>

#include <functional>

namespace vug::scene {

/// Calls `visit(parent, child)` for each range of an element of a document and the ranges of its
/// parts, and `expression(expr)` for each expression.
class ExtentVisitor {
 public:
  using Visit = std::function<void(const SourceLocation& parent, const SourceLocation& child)>;
  using Expression = std::function<void(const Expr&)>;

  ExtentVisitor(Visit visit, Expression expression)
      : visit_(std::move(visit)), expression_(std::move(expression)) {}

  void document(const Document& document) const {
    for (const Param& one : document.params) {
      part(one.extent, one.where);
      for (const ExprPtr& each : {one.value, one.low, one.high}) part(one.extent, each);
      if (one.given) part(one.given->extent, one.given);
    }
    for (const Let& one : document.lets) let(one);
    for (const Def& one : document.defs) {
      part(one.extent, one.where);
      formals(one.extent, one.formals);
      part(one.extent, one.body);
      locals(one.extent, one.locals);
    }
    for (const Declaration& one : document.declarations) {
      for (const SourceLocation* each : {&one.kind_where, &one.where}) part(one.extent, *each);
      for (const ExprPtr& each : {one.value, one.target}) part(one.extent, each);
      for (const ExprPtr& each : one.more_targets) part(one.extent, each);
      if (one.loop) loop(one.extent, *one.loop);
      entries(one.extent, one.entries);
    }
    for (const Grammar& one : document.grammars) grammar(one);
  }

 private:
  void part(const SourceLocation& parent, const SourceLocation& child) const {
    visit_(parent, child);
  }
  void part(const SourceLocation& parent, const ExprPtr& expr) const {
    if (!expr) return;
    visit_(parent, expr->extent);
    visit_(expr->extent, expr->where);
    expression_(*expr);
    for (const Operand& operand : expr->operands) {
      visit_(expr->extent, operand.where);
      formals(operand.where, operand.binds);
      part(expr->extent, operand.value);
    }
  }
  /// The loop of a declaration, which is not an expression by itself.
  void loop(const SourceLocation& parent, const Expr& loop) const {
    part(parent, loop.extent);
    for (const Operand& clause : loop.operands) {
      part(loop.extent, clause.where);
      formals(clause.where, clause.binds);
      if (!clause.name.empty()) part(clause.where, clause.value);
    }
  }
  void formals(const SourceLocation& parent, const std::vector<Formal>& all) const {
    for (const Formal& one : all) {
      part(parent, one.where);
      part(parent, one.fallback);
    }
  }
  void let(const Let& one) const {
    part(one.extent, one.where);
    part(one.extent, one.value);
  }
  void locals(const SourceLocation& parent, const std::vector<Let>& all) const {
    for (const Let& one : all) {
      part(parent, one.extent);
      let(one);
    }
  }
  void entries(const SourceLocation& parent, const std::vector<Entry>& all) const {
    for (const Entry& one : all) {
      part(parent, one.extent);
      part(one.extent, one.where);
      for (const ExprPtr& each : one.values) part(one.extent, each);
    }
  }
  void items(const SourceLocation& parent, const std::vector<Item>& all) const {
    for (const Item& one : all) {
      part(parent, one.where);
      for (const ExprPtr& each : {one.amount, one.shape, one.count}) part(one.where, each);
      entries(one.where, one.clauses);
    }
  }
  void grammar(const Grammar& grammar) const {
    part(grammar.extent, grammar.where);
    items(grammar.extent, grammar.axiom);
    entries(grammar.extent, grammar.options);
    for (const Rule& one : grammar.rules) {
      part(grammar.extent, one.extent);
      part(one.extent, one.where);
      formals(one.extent, one.formals);
      for (const ExprPtr& each : {one.weight, one.guard}) part(one.extent, each);
      items(one.extent, one.items);
      locals(one.extent, one.locals);
    }
    if (grammar.lsystem) lsystem(grammar.extent, *grammar.lsystem);
  }
  void lsystem(const SourceLocation& parent, const LSystem& system) const {
    word(parent, system.axiom);
    for (const ProductionTable& one : system.tables) {
      part(parent, one.extent);
      part(one.extent, one.where);
      for (const Production& each : one.productions) part(one.extent, each.extent);
    }
    for (const ProductionStage* one : {&system.decompose, &system.interpret}) {
      if (!one->where.known()) continue;
      part(parent, one->extent);
      part(one->extent, one->where);
      part(one->extent, one->depth);
      for (const Production& each : one->productions) part(one->extent, each.extent);
    }
    for_each_production(system, [&](const Production& one) {
      part(parent, one.extent);
      patterns(one.extent, one.left);
      patterns(one.extent, {one.head});
      patterns(one.extent, one.right);
      for (const ExprPtr& each : {one.weight, one.guard, one.after}) part(one.extent, each);
      word(one.extent, one.word);
      locals(one.extent, one.locals);
    });
  }
  void patterns(const SourceLocation& parent, const std::vector<Pattern>& all) const {
    for (const Pattern& one : all) {
      part(parent, one.where);
      formals(one.where, one.formals);
    }
  }
  void word(const SourceLocation& parent, const ModuleString& word) const {
    for (const Module& one : word) {
      part(parent, one.where);
      for (const ExprPtr& each : one.arguments) part(one.where, each);
    }
  }

  Visit visit_;
  Expression expression_;
};

}  // namespace vug::scene
