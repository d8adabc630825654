// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/check.h>
#include <vug/scene/def_check.h>
#include <vug/scene/inline_locals.h>
#include <vug/scene/lsystem_check.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace vug::scene {

namespace {

constexpr const char* kReserved[] = {"and",  "or",    "not", "if",    "in", "on",
                                     "true", "false", "pi",  "frame", "for"};

bool is_reserved(const std::string& name) {
  return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
}

class NameChecker {
 public:
  explicit NameChecker(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void run(Document& document) {
    std::vector<Global> all;
    for (const Param& one : document.params) all.push_back({"parameter", &one.name, &one.where});
    for (const Let& one : document.lets) all.push_back({"let", &one.name, &one.where});
    // In the order of the text, so that the second declaration is reported.
    std::map<std::string, size_t> rank;
    for (const auto& source : document.sources) rank.emplace(source->file, rank.size());
    std::stable_sort(all.begin(), all.end(), [&](const Global& a, const Global& b) {
      const size_t first = rank[a.where->file], second = rank[b.where->file];
      return first != second ? first < second : a.where->line < b.where->line;
    });
    for (Def& one : document.defs) def(one, document.skipped);
    check_calls(document, diagnostics_);
    defs_of_text_ = &document.defs;
    for (const ImportedModule& one : document.modules) module(one, document);
    for (const Global& one : all)
      if (!declare_global(one.what, *one.name, *one.where))
        document.skipped.doubtful.insert(*one.name);
    for (const Declaration& made : document.declarations)
      if (!made.broken && !declare(made.kind, made.name, made.where))
        document.skipped.doubtful.insert(made.name);
    for (Grammar& made : document.grammars) {
      if (!declare("grammar", made.name, made.where)) document.skipped.doubtful.insert(made.name);
      const size_t before = diagnostics_.all().size();
      grammar(made);
      const auto reported = diagnostics_.all().begin() + static_cast<std::ptrdiff_t>(before);
      made.broken = made.broken ||
                    std::any_of(reported, diagnostics_.all().end(),
                                [](const auto& one) { return one.severity == Severity::error; });
    }
  }

 private:
  /// Checks a name without the prefix of its module.
  bool allowed(const std::string& full, const SourceLocation& where) {
    const std::string name = full.substr(full.rfind('.') + 1);
    if (may_name(name)) return true;
    diagnostics_.error(where,
                       fmt::format("'{}' is {} and cannot be used as a name", name,
                                   is_unit(name) ? "a unit" : "a keyword"),
                       fmt::format("use another name, e.g. '{}1'", name));
    return false;
  }

  void report_duplicate(const char* what, const std::string& name, const SourceLocation& where,
                        const SourceLocation& first) {
    diagnostics_.error(where, fmt::format("duplicate {} '{}'", what, name),
                       fmt::format("the first is at {}", to_string(first)));
  }

  struct Global {
    const char* what;
    const std::string* name;
    const SourceLocation* where;
  };

  /// Parameters and lets share one namespace.
  bool declare_global(const char* what, const std::string& name, const SourceLocation& where) {
    if (!allowed(name, where)) return false;
    const auto [place, fresh] = globals_.emplace(name, where);
    if (!fresh) report_duplicate(what, name, where, place->second);
    return fresh;
  }

  /// Each kind of declarations has a namespace.
  bool declare(const std::string& kind, const std::string& name, const SourceLocation& where) {
    if (!allowed(name, where)) return false;
    const auto [place, fresh] = declared_.emplace(kind + ' ' + name, where);
    if (!fresh) {
      report_duplicate(kind.c_str(), name, where, place->second);
      return false;
    }
    return true;
  }

  /// A module's name before a "." must mean nothing else.
  void module(const ImportedModule& module, const Document& document) {
    if (!allowed(module.name, module.where)) return;
    const auto [place, fresh] = modules_.emplace(module.name, module.where);
    if (!fresh) return report_duplicate("module", module.name, module.where, place->second);
    const Param* param = document.find_param(module.name);
    const Let* let = document.find_let(module.name);
    const Declaration* declaration = document.find(module.name);
    if (!param && !let && !declaration) return;
    const SourceLocation& where = param ? param->where : let ? let->where : declaration->where;
    diagnostics_.error(
        module.where, fmt::format("the name '{}' is already used", module.name),
        fmt::format("the first is at {}; use another name after 'as'", to_string(where)));
  }

  /// The names of functions are only used in calls: they are a namespace of their own.
  void def(const Def& def, SkippedNames& skipped) {
    if (!allowed(def.name, def.where)) return;
    const auto [place, fresh] = defs_.emplace(def.name, def.where);
    if (!fresh) report_duplicate("def", def.name, def.where, place->second);
    if (!fresh) skipped.doubtful.insert(def.name);
    std::set<std::string> names;
    for (const Formal& formal : def.formals)
      if (allowed(formal.name, formal.where) && !names.insert(formal.name).second)
        diagnostics_.error(formal.where,
                           fmt::format("duplicate parameter '{}' of '{}'", formal.name, def.name));
    locals(def.locals, names, def.name);
  }

  void locals(const std::vector<Let>& locals, std::set<std::string> names,
              const std::string& whose) {
    for (const Let& local : locals)
      if (allowed(local.name, local.where) && !names.insert(local.name).second)
        diagnostics_.error(local.where,
                           fmt::format("duplicate name '{}' in '{}'", local.name, whose));
  }

  void grammar(const Grammar& grammar) {
    const bool dresses =
        std::any_of(grammar.options.begin(), grammar.options.end(),
                    [](const Entry& option) { return option.key == kDressOption; });
    if (!grammar.axiom_where.known() && !grammar.broken && !dresses)
      diagnostics_.error(grammar.where, fmt::format("grammar '{}' has no axiom", grammar.name),
                         "write 'axiom' followed by the initial symbols");
    if (grammar.lsystem) return lsystem(*grammar.lsystem);
    std::map<std::string, std::set<size_t>> arities;
    for (const Rule& rule : grammar.rules) {
      arities[rule.head].insert(rule.formals.size());
      std::set<std::string> names;
      for (const Formal& formal : rule.formals)
        if (allowed(formal.name, formal.where) && !names.insert(formal.name).second)
          diagnostics_.error(formal.where, fmt::format("duplicate parameter '{}' of '{}'",
                                                       formal.name, rule.head));
      locals(rule.locals, names, rule.head);
      if (grammar.kind == "facade" && !rule.locals.empty()) inlined_locals(rule);
    }
    for (const std::string& head : grammar.broken_rules) arities.erase(head);
    if (grammar.kind == "facade") return;  // symbols may be arguments, too: see facade/rules.h
    items(grammar.axiom, arities);
    for (const Rule& rule : grammar.rules) items(rule.items, arities);
  }

  void inlined_locals(const Rule& rule) {
    std::vector<ExprPtr> uses = {rule.weight, rule.guard};
    for (const Item& item : rule.items) uses.push_back(item.shape);
    check_locals(rule.locals, uses, drawing(), diagnostics_);
  }

  /// The functions that draw random numbers, which only names of rules need.
  const std::set<std::string>& drawing() {
    if (!drawing_) drawing_ = drawing_functions(*defs_of_text_);
    return *drawing_;
  }

  void lsystem(const LSystem& system) {
    check_lsystem(
        system,
        [&](const std::string& name, const SourceLocation& where) { return allowed(name, where); },
        diagnostics_);
    for_each_production(system, [&](const Production& one) {
      if (one.locals.empty()) return;
      std::set<std::string> formals;
      std::vector<ExprPtr> uses = {one.weight, one.guard, one.after};
      for (const std::vector<Pattern>& side : {one.left, {one.head}, one.right})
        for (const Pattern& pattern : side)
          for (const Formal& formal : pattern.formals) formals.insert(formal.name);
      for (const Module& module : one.word)
        uses.insert(uses.end(), module.arguments.begin(), module.arguments.end());
      locals(one.locals, formals, one.head.name);
      check_locals(one.locals, uses, drawing(), diagnostics_);
    });
  }

  void items(const std::vector<Item>& items,
             const std::map<std::string, std::set<size_t>>& arities) {
    for (const Item& item : items) {
      if (!item.op.empty()) continue;
      for (const Operand& argument : item.shape->operands)
        if (!argument.name.empty())
          diagnostics_.error(argument.where, "symbols take their arguments by position");
      const auto known = arities.find(item.symbol());
      const size_t given = item.shape->operands.size();
      if (known == arities.end() || known->second.count(given)) continue;
      std::string takes;
      for (const size_t count : known->second)
        takes += fmt::format("{}{}", takes.empty() ? "" : " or ", count);
      diagnostics_.error(
          item.where,
          fmt::format("'{}' has {} argument{}", item.symbol(), given, given == 1 ? "" : "s"),
          fmt::format("its rules take {}", takes));
    }
  }

  Diagnostics& diagnostics_;
  std::map<std::string, SourceLocation> modules_;
  std::map<std::string, SourceLocation> defs_;
  std::map<std::string, SourceLocation> globals_;
  std::map<std::string, SourceLocation> declared_;
  const std::vector<Def>* defs_of_text_ = nullptr;
  std::optional<std::set<std::string>> drawing_;  ///< See drawing().
};

}  // namespace

bool may_name(const std::string& name) {
  return !is_reserved(name) && (!is_unit(name) || name.size() == 1);
}

void check_names(Document& document, Diagnostics& diagnostics) {
  NameChecker(diagnostics).run(document);
}

}  // namespace vug::scene
