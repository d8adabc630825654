// SPDX-License-Identifier: Apache-2.0
// L-systems of documents as text in a canonical form, for comparisons in tests.
#include <vug/scene/lsystem_document.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

std::string dump_optional(const ExprPtr& expr) { return expr ? scene::dump(*expr) : "-"; }

std::string dump_patterns(const std::vector<Pattern>& patterns) {
  std::string out;
  for (const Pattern& one : patterns) {
    out += ' ' + one.name + '(';
    for (const Formal& formal : one.formals) out += formal.name + ',';
    out += ')';
  }
  return out;
}

std::string dump_word(const ModuleString& word) {
  std::string out;
  for (const Module& module : word) {
    out += ' ' + module.name + '(';
    for (const ExprPtr& argument : module.arguments) out += dump_optional(argument) + ',';
    out += ')';
  }
  return out;
}

std::string dump_locals(const std::vector<Let>& locals) {
  std::string out;
  for (const Let& local : locals)
    out += fmt::format(" where {} = {}", local.name, dump_optional(local.value));
  return out;
}

std::string dump_productions(const std::vector<Production>& productions) {
  std::string out;
  for (const Production& one : productions)
    out += fmt::format("  {} <{} >{} @ {} if {} after {} ->{}{}\n", dump_patterns(one.left),
                       dump_patterns({one.head}), dump_patterns(one.right),
                       dump_optional(one.weight), dump_optional(one.guard),
                       dump_optional(one.after), dump_word(one.word), dump_locals(one.locals));
  return out;
}

}  // namespace

std::string dump(const LSystem& system) {
  std::string out =
      "  axiom" + dump_word(system.axiom) + '\n' + dump_productions(system.productions);
  for (const ProductionTable& table : system.tables)
    out += fmt::format("  table {}\n{}", table.name, dump_productions(table.productions));
  for (const ScheduleTurn& turn : system.schedule)
    out += fmt::format("  turn {} * {}\n", turn.table, dump_optional(turn.count));
  for (const auto& [name, stage] :
       {std::pair("decompose", &system.decompose), std::pair("interpret", &system.interpret)})
    out += fmt::format("  {} depth {}\n{}", name, dump_optional(stage->depth),
                       dump_productions(stage->productions));
  for (const auto& [name, list] :
       {std::pair("ignore", &system.ignore), std::pair("consider", &system.consider),
        std::pair("ages", &system.ages)})
    out += fmt::format("  {}{}\n", name, dump_patterns(*list));
  return out;
}

}  // namespace vug::scene
