// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/lsystem_check.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace vug::scene {

namespace {

void check_formals(const Production& production, const NameAllowed& allowed,
                   Diagnostics& diagnostics) {
  std::set<std::string> names;
  // Published systems also use the parameter names s and m, which hide the units in the rule.
  const auto may_be = [&](const Formal& formal) {
    return (is_unit(formal.name) && formal.name != "in") || allowed(formal.name, formal.where);
  };
  const auto visit = [&](const Pattern& pattern) {
    for (const Formal& formal : pattern.formals)
      if (may_be(formal) && !names.insert(formal.name).second)
        diagnostics.error(
            formal.where,
            fmt::format("duplicate parameter '{}' in the head of a rule", formal.name));
  };
  for (const Pattern& one : production.left) visit(one);
  visit(production.head);
  for (const Pattern& one : production.right) visit(one);
}

using Arities = std::map<std::string, std::set<size_t>>;

void check_arities(const ModuleString& word, const Arities& arities, Diagnostics& diagnostics) {
  for (const Module& module : word) {
    const auto known = arities.find(module.name);
    const size_t given = module.arguments.size();
    if (known == arities.end() || known->second.count(given) || is_turtle_name(module.name))
      continue;
    std::string takes;
    for (const size_t count : known->second)
      takes += fmt::format("{}{}", takes.empty() ? "" : " or ", count);
    diagnostics.error(
        module.where,
        fmt::format("'{}' has {} parameter{}", module.name, given, given == 1 ? "" : "s"),
        fmt::format("its rules take {}", takes));
  }
}

/// `a -> ab` produces a module named ab, but words with lower-case letters copied from publications
/// mean two modules.
void warn_of_joined_names(const ModuleString& word, const Arities& arities,
                          Diagnostics& diagnostics) {
  for (const Module& module : word) {
    const std::string& name = module.name;
    const bool joined =
        name.size() > 1 && !arities.count(name) &&
        std::all_of(name.begin(), name.end(), [&](char letter) {
          return letter >= 'a' && letter <= 'z' && arities.count(std::string(1, letter));
        });
    if (!joined) continue;
    std::string apart(1, name[0]);
    for (size_t i = 1; i < name.size(); ++i) apart += fmt::format(" {}", name[i]);
    diagnostics.warning(module.where, fmt::format("'{}' is a single module without a rule", name),
                        fmt::format("write spaces between lower-case letters: {}", apart));
  }
}

}  // namespace

void check_lsystem(const LSystem& system, const NameAllowed& allowed, Diagnostics& diagnostics) {
  Arities arities;
  for_each_production(system, [&](const Production& production) {
    check_formals(production, allowed, diagnostics);
    arities[production.head.name].insert(production.head.formals.size());
  });
  const auto check_word = [&](const ModuleString& word) {
    check_arities(word, arities, diagnostics);
    warn_of_joined_names(word, arities, diagnostics);
  };
  check_word(system.axiom);
  for_each_production(system, [&](const Production& one) { check_word(one.word); });
  std::vector<std::string> tables;
  for (const ProductionTable& table : system.tables) tables.push_back(table.name);
  for (const ScheduleTurn& turn : system.schedule)
    if (std::find(tables.begin(), tables.end(), turn.table) == tables.end())
      diagnostics.error(turn.where, fmt::format("unknown table '{}'", turn.table),
                        suggestion(turn.table, tables));
  if (!system.ignore.empty() && !system.consider.empty())
    diagnostics.error(
        system.consider[0].where, "'consider' cannot be combined with 'ignore'",
        "use one of them: contexts skip the modules of 'ignore', or all except those of "
        "'consider'");
  if (!system.tables.empty() && system.schedule.empty())
    diagnostics.error(system.tables[0].where, "tables without a schedule",
                      fmt::format("add 'schedule {}'", system.tables[0].name));
}

}  // namespace vug::scene
