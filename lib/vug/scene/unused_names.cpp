// SPDX-License-Identifier: Apache-2.0
// Warnings about parameters, lets and functions that nothing uses.
#include <vug/scene/check.h>
#include <vug/scene/lsystem_document.h>

#include <fmt/format.h>

#include <set>
#include <string_view>

namespace vug::scene {

namespace {

/// Collects all names used in expressions except formal parameters.
class NameCollector {
 public:
  void add(const ExprPtr& expr) {
    if (!expr) return;
    if (expr->kind == ExprKind::call) calls.insert(full_name(*expr));
    if (expr->kind == ExprKind::name && !hidden_.count(expr->text)) names.insert(full_name(*expr));
    const auto outer = hidden_;
    for (const Operand& part : expr->operands) {
      add(part.value);
      hide(part.binds);
    }
    if (expr->kind == ExprKind::comprehension) hidden_ = outer;
  }
  void add(const Def& def) {
    for (const Formal& formal : def.formals) {
      add(formal.fallback);
      hidden_.insert(formal.name);
    }
    add_with_locals(def.locals, [&] { add(def.body); });
  }
  void add(const std::vector<Entry>& entries) {
    for (const Entry& entry : entries)
      for (const ExprPtr& value : entry.values) add(value);
  }
  void add(const std::vector<Item>& items) {
    for (const Item& item : items) {
      for (const ExprPtr& expr : {item.amount, item.shape, item.count}) add(expr);
      add(item.clauses);
    }
  }
  void add(const Rule& rule) {
    hide(rule.formals);
    add_with_locals(rule.locals, [&] {
      add(rule.weight);
      add(rule.guard);
      add(rule.items);
    });
  }
  void add(const LSystem& system) {
    const auto add_word = [&](const ModuleString& word) {
      for (const Module& module : word)
        for (const ExprPtr& argument : module.arguments) add(argument);
    };
    add_word(system.axiom);
    for (const ScheduleTurn& turn : system.schedule) add(turn.count);
    add(system.decompose.depth);
    add(system.interpret.depth);
    for_each_production(system, [&](const Production& one) {
      for (const Pattern& pattern : one.left) hide(pattern.formals);
      hide(one.head.formals);
      for (const Pattern& pattern : one.right) hide(pattern.formals);
      add_with_locals(one.locals, [&] {
        for (const ExprPtr& expr : {one.weight, one.guard, one.after}) add(expr);
        add_word(one.word);
      });
    });
  }

  /// Hides the variables of a declaration's loop until `show_all`.
  void hide_variables(const Expr& loop) {
    for (const Operand& clause : loop.operands) hide(clause.binds);
  }
  void show_all() { hidden_.clear(); }

  std::set<std::string> names;
  std::set<std::string> calls;  ///< Names of called functions.

 private:
  void hide(const std::vector<Formal>& formals) {
    for (const Formal& formal : formals) hidden_.insert(formal.name);
  }
  /// Runs the work while the names of `where` are hidden, too; then no name is hidden.
  template <class Work>
  void add_with_locals(const std::vector<Let>& locals, const Work& work) {
    for (const Let& local : locals) hidden_.insert(local.name);
    for (const Let& local : locals) add(local.value);
    work();
    hidden_.clear();
  }

  std::set<std::string> hidden_;
};

}  // namespace

void check_unused_names(const Document& document, Diagnostics& diagnostics) {
  NameCollector reader;
  reader.add(document.seed);
  for (const Param& param : document.params)
    for (const ExprPtr& expr : {param.value, param.low, param.high, param.given}) reader.add(expr);
  for (const Let& let : document.lets) reader.add(let.value);
  for (const Def& def : document.defs) reader.add(def);
  for (const Declaration& made : document.declarations) {
    reader.add(made.loop);
    if (made.loop) reader.hide_variables(*made.loop);
    reader.add(made.value);
    reader.add(made.target);
    for (const ExprPtr& target : made.more_targets) reader.add(target);
    reader.add(made.entries);
    reader.show_all();
  }
  for (const Grammar& grammar : document.grammars) {
    reader.add(grammar.axiom);
    reader.add(grammar.options);
    for (const Rule& rule : grammar.rules) reader.add(rule);
    if (grammar.lsystem) reader.add(*grammar.lsystem);
  }
  const auto check = [&](const char* word, const std::string& name, const SourceLocation& where) {
    const bool included = !document.sources.empty() && where.file != document.sources[0]->file;
    const bool function = std::string_view(word) == "def";
    if (!included && !(function ? reader.calls : reader.names).count(name) &&
        !document.skipped.may_mention(name) && !document.skipped.doubtful.count(name))
      diagnostics.warning(where, fmt::format("{} '{}' is never used", word, name),
                          function ? "call it in an expression or remove it"
                                   : "use it in an expression or remove it");
  };
  for (const Param& param : document.params) check("param", param.name, param.where);
  for (const Let& let : document.lets) check("let", let.name, let.where);
  for (const Def& def : document.defs) check("def", def.name, def.where);
}

}  // namespace vug::scene
