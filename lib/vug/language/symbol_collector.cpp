// SPDX-License-Identifier: Apache-2.0
// The statements and grammars of a document; names in expressions: expression_names.cpp.
#include <vug/language/kinds.h>
#include <vug/language/symbol_collector.h>

#include <algorithm>

namespace vug::language {

SymbolTable collect_symbols(const scene::Document& document) {
  return SymbolCollector(document).run();
}

SymbolTable SymbolCollector::run() {
  declare_all();
  expr(document_.seed);
  for (const scene::Param& param : document_.params)
    for (const scene::ExprPtr& each : {param.value, param.low, param.high, param.given}) expr(each);
  for (const scene::Let& let : document_.lets) expr(let.value);
  for (const scene::Def& def : document_.defs) function(def);
  for (const scene::Declaration& made : document_.declarations) declaration(made);
  for (const scene::Grammar& made : document_.grammars) grammar(made);
  given_values();
  return std::move(table_);
}

void SymbolCollector::declare_all() {
  for (const auto& one : document_.params)
    add_global(SymbolKind::param, one.name, "param", one.where, one.extent, one.doc);
  for (const auto& one : document_.lets)
    add_global(SymbolKind::let, one.name, "let", one.where, one.extent);
  for (const auto& one : document_.defs)
    add_global(SymbolKind::function, one.name, "def", one.where, one.extent, one.doc);
  for (const auto& one : document_.modules)
    add_global(SymbolKind::module, one.name, "include", one.where, one.where);
  for (const auto& one : document_.declarations)
    add_global(SymbolKind::declaration, one.name, one.kind.c_str(), one.where, one.extent);
  for (const auto& one : document_.grammars)
    add_global(SymbolKind::grammar, one.name, "grammar", one.where, one.extent);
}

int SymbolCollector::add(Symbol symbol) {
  const int index = static_cast<int>(table_.symbols.size());
  symbol.outer = outer_;
  refer(symbol.where, index, true);
  table_.symbols.push_back(std::move(symbol));
  return index;
}

void SymbolCollector::add_global(SymbolKind kind, const std::string& full, const char* keyword,
                                 const SourceLocation& where, const SourceLocation& extent,
                                 const std::string& doc) {
  const int index =
      add({kind, full.substr(full.rfind('.') + 1), full, keyword, where, extent, {}, doc, -1});
  if (kind == SymbolKind::param || kind == SymbolKind::let) globals_.emplace(full, index);
  if (kind == SymbolKind::function) functions_.emplace(full, index);
  if (kind == SymbolKind::module) modules_.emplace(full, index);
  if (kind == SymbolKind::declaration || kind == SymbolKind::grammar)
    declared_[full].push_back(index);
}

int SymbolCollector::add_local(SymbolKind kind, const scene::Formal& formal,
                               const SourceLocation& scope) {
  const int index =
      add({kind, formal.name, formal.name, "", formal.where, formal.where, scope, formal.doc, -1});
  locals_.emplace_back(formal.name, index);
  return index;
}

void SymbolCollector::refer(const SourceLocation& where, int symbol, bool declares) {
  if (where.known()) table_.references.push_back({where, symbol, declares, true});
}

void SymbolCollector::function(const scene::Def& def) {
  const LocalScope scope(locals_);
  outer_ = functions_.at(def.name);
  for (const scene::Formal& formal : def.formals) {
    expr(formal.fallback);
    add_local(SymbolKind::parameter, formal, def.extent);
  }
  locals(def.locals, def.extent);
  expr(def.body);
  outer_ = -1;
}

void SymbolCollector::locals(const std::vector<scene::Let>& all, const SourceLocation& scope) {
  for (const scene::Let& local : all)
    add_local(SymbolKind::local, {local.name, local.where}, scope);
  for (const scene::Let& local : all) expr(local.value);
}

void SymbolCollector::declaration(const scene::Declaration& made) {
  if (made.kind == "variant") return variant(made);
  const LocalScope scope(locals_);
  for (const int index : declared_[made.name])
    if (table_.symbols[static_cast<size_t>(index)].where == made.where) outer_ = index;
  if (made.loop)
    for (const scene::Operand& clause : made.loop->operands) {
      if (!clause.name.empty()) expr(clause.value);
      for (const scene::Formal& bound : clause.binds)
        add_local(SymbolKind::variable, bound, made.extent);
    }
  expr(made.value, made.kind);
  const std::string_view target = made.kind == "object" || made.kind == "cells" ? "mesh" : "";
  expr(made.target, made.kind == "mesh" ? "volume" : target);
  for (const scene::ExprPtr& each : made.more_targets) expr(each, target);
  const scene::Entry* kind = made.find_entry("kind");
  const bool named =
      kind && !kind->values.empty() && kind->values[0]->kind == scene::ExprKind::name;
  const auto params = block_params(made.kind, named ? kind->values[0]->text : "");
  for (const scene::Entry& each : made.entries) {
    if (each.key == "kind") continue;
    const auto param = std::find_if(params.begin(), params.end(),
                                    [&](const ParamInfo* one) { return one->name == each.key; });
    entry(each, param == params.end() ? nullptr : *param,
          each.key == "of" ? (made.kind == "place" ? "object" : "mesh") : each.key);
  }
  outer_ = -1;
}

/// The keys of a variant are params.
void SymbolCollector::variant(const scene::Declaration& made) {
  for (const scene::Entry& each : made.entries) {
    if (const auto param = globals_.find(each.key); param != globals_.end()) {
      SourceLocation where = each.where;  // the name after the prefix of a module
      const std::string& name = table_.symbols[static_cast<size_t>(param->second)].name;
      if (where.line == where.end_line)
        where.column = where.end_column - static_cast<int>(name.size());
      refer(where, param->second);
    }
    for (const scene::ExprPtr& value : each.values) expr(value);
  }
}

/// `otherwise` is the kind of declaration that a name in the entry means if several have this name.
void SymbolCollector::entry(const scene::Entry& entry, const ParamInfo* param,
                            std::string_view otherwise) {
  if (param && entry.values.size() == 1 && entry.values[0]->kind == scene::ExprKind::name &&
      has_choice(*param, entry.values[0]->text))
    return;
  for (const scene::ExprPtr& value : entry.values) expr(value, otherwise);
}

/// The keys of `include "file" as NAME { PARAM VALUE }`, which the document does not contain: each
/// is the word before the value.
void SymbolCollector::given_values() {
  std::map<std::string, std::vector<scene::Token>> tokens;
  for (const scene::Param& param : document_.params) {
    if (!param.given || !param.given->extent.known()) continue;
    const SourceLocation& value = param.given->extent;
    for (const auto& source : document_.sources) {
      if (source->file != value.file) continue;
      Diagnostics ignored;
      const auto [lexed, fresh] = tokens.try_emplace(source->file);
      if (fresh) lexed->second = scene::lex(source->text, source->file, ignored);
      const std::vector<scene::Token>& all = lexed->second;
      auto at = std::find_if(all.begin(), all.end(), [&](const scene::Token& token) {
        return Position{token.line, token.column} >= begin_of(value);
      });
      while (at != all.begin() && (at - 1)->is("(")) --at;
      if (at == all.begin()) continue;
      const scene::Token& key = *(at - 1);
      const int symbol = globals_.at(param.name);
      if (key.is_name(table_.symbols[static_cast<size_t>(symbol)].name))
        refer({value.file, key.line, key.column, key.end_line(), key.end_column()}, symbol);
    }
  }
}

void SymbolCollector::grammar(const scene::Grammar& made) {
  heads_.clear();
  tables_.clear();
  for (const int index : declared_[made.name])
    if (table_.symbols[static_cast<size_t>(index)].where == made.where) outer_ = index;
  const KindInfo* info = find_declaration(made.kind);
  for (const scene::Entry& option : made.options)
    entry(option, info ? find_param(*info, 0, option.key) : nullptr, option.key);
  for (const scene::Rule& each : made.rules) head(each.head, each.where, each.extent);
  const bool places = made.kind == "facade";
  heads_are_values_ = places;
  for (const scene::Item& each : made.axiom) item(each, places);
  for (const scene::Rule& each : made.rules) rule(each, made);
  if (made.lsystem) lsystem(*made.lsystem, made);
  heads_are_values_ = false;
  outer_ = -1;
}

void SymbolCollector::head(const std::string& name, const SourceLocation& where,
                           const SourceLocation& extent) {
  if (const auto known = heads_.find(name); known != heads_.end())
    return refer(where, known->second, true);
  const SourceLocation grammar =
      outer_ < 0 ? extent : table_.symbols[static_cast<size_t>(outer_)].extent;
  heads_[name] = add({SymbolKind::rule, name, name, "grammar", where, extent, grammar, {}, outer_});
}

void SymbolCollector::rule(const scene::Rule& rule, const scene::Grammar& grammar) {
  const LocalScope scope(locals_);
  for (const scene::Formal& formal : rule.formals)
    add_local(SymbolKind::parameter, formal, rule.extent);
  locals(rule.locals, rule.extent);
  expr(rule.weight);
  expr(rule.guard);
  for (const scene::Item& each : rule.items) item(each, grammar.kind == "facade");
}

void SymbolCollector::item(const scene::Item& item, bool places) {
  expr(item.amount);
  const bool symbol = item.op.empty() && symbol_of_rule(*item.shape);
  if (!symbol) {
    expr(item.shape, places ? "element" : "field");
  } else {
    for (const scene::Operand& operand : item.shape->operands) expr(operand.value);
  }
  expr(item.count);
  for (const scene::Entry& clause : item.clauses) {
    const KindInfo* info = find_declaration("grammar");
    entry(clause, info ? find_param(*info, 0, clause.key) : nullptr, clause.key);
  }
}

/// Adds the reference of a name or call that is a symbol with a rule.
bool SymbolCollector::symbol_of_rule(const scene::Expr& expr) {
  const bool plain =
      expr.kind == scene::ExprKind::name || (expr.kind == scene::ExprKind::call && !expr.method);
  const auto found = plain ? heads_.find(expr.text) : heads_.end();
  if (found == heads_.end()) return false;
  refer(scene::word_at(expr.where, expr.text), found->second);
  return true;
}

void SymbolCollector::lsystem(const scene::LSystem& system, const scene::Grammar& grammar) {
  scene::for_each_production(system, [&](const scene::Production& one) {
    head(one.head.name, scene::word_at(one.head.where, one.head.name), one.extent);
  });
  for (const scene::ProductionTable& table : system.tables)
    tables_[table.name] = add({SymbolKind::table,
                               table.name,
                               table.name,
                               "table",
                               table.where,
                               table.extent,
                               grammar.extent,
                               {},
                               outer_});
  for (const scene::ScheduleTurn& turn : system.schedule) {
    if (const auto table = tables_.find(turn.table); table != tables_.end())
      refer(scene::word_at(turn.where, turn.table), table->second);
    expr(turn.count);
  }
  word(system.axiom);
  expr(system.decompose.depth);
  expr(system.interpret.depth);
  scene::for_each_production(system, [&](const scene::Production& one) { production(one); });
  for (const auto* names : {&system.ignore, &system.consider, &system.ages})
    for (const scene::Pattern& each : *names)
      if (const auto known = heads_.find(each.name); known != heads_.end())
        refer(scene::word_at(each.where, each.name), known->second);
}

void SymbolCollector::production(const scene::Production& one) {
  const LocalScope scope(locals_);
  const auto bind = [&](const scene::Pattern& pattern, bool is_head) {
    if (const auto known = heads_.find(pattern.name); !is_head && known != heads_.end())
      refer(scene::word_at(pattern.where, pattern.name), known->second);
    for (const scene::Formal& formal : pattern.formals)
      add_local(SymbolKind::parameter, formal, one.extent);
  };
  for (const scene::Pattern& each : one.left) bind(each, false);
  bind(one.head, true);
  for (const scene::Pattern& each : one.right) bind(each, false);
  locals(one.locals, one.extent);
  for (const scene::ExprPtr& each : {one.weight, one.guard, one.after}) expr(each);
  word(one.word);
}

void SymbolCollector::word(const scene::ModuleString& word) {
  for (const scene::Module& module : word) {
    if (const auto known = heads_.find(module.name); known != heads_.end())
      refer(scene::word_at(module.where, module.name), known->second);
    for (const scene::ExprPtr& argument : module.arguments) expr(argument);
  }
}

}  // namespace vug::language
