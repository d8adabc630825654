// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/compile.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace vug::fit {
namespace {

const std::map<std::string, RegionType>& element_types() {
  static const std::map<std::string, RegionType> types = {{"window", RegionType::window},
                                                          {"door", RegionType::door},
                                                          {"doorway", RegionType::door},
                                                          {"shop", RegionType::shop}};
  return types;
}

/// A flag argument of a split, such as `regular: false`.
bool flag(const facade::Item& split, const std::string& name) {
  for (const scene::Operand& operand : split.expr->operands)
    if (operand.name == name) return operand.value->text == "true";
  return true;
}

class Compiler {
 public:
  explicit Compiler(const facade::Rules& from) : from_(from) {}

  Rules compile() {
    for (const std::string& name : from_.symbols()) {
      SymbolInfo info;
      info.name = name;
      const auto type = element_types().find(name);
      info.terminal = type != element_types().end();
      if (info.terminal) info.type = type->second;
      out_.symbols.push_back(info);
    }
    for (const facade::Rule& rule : from_.rules) find_grid(rule);
    for (const facade::Rule& rule : from_.rules) add(rule);
    if (from_.axiom.size() != 1 || from_.axiom[0].kind != facade::ItemKind::symbol)
      throw Error(ErrorCode::bad_input, "the axiom of a grammar to be fitted must be one symbol",
                  from_.where);
    out_.axiom = symbol(from_.axiom[0]);
    return with_index(std::move(out_));
  }

 private:
  [[noreturn]] static void refuse(const facade::Rule& rule, const std::string& why) {
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' cannot be fitted: {}", facade::to_string(rule), why), rule.where,
                "see data/facades/ripperda.vug for supported rules");
  }

  int find(const std::string& name) const {
    for (size_t i = 0; i < out_.symbols.size(); ++i)
      if (out_.symbols[i].name == name) return static_cast<int>(i);
    return -1;
  }
  int symbol(const facade::Item& item) const {
    const int found = find(item.name);
    if (found < 0)
      throw Error(ErrorCode::bad_input, fmt::format("'{}' cannot be fitted", item.name),
                  item.where);
    return found;
  }

  static const facade::Item& only_item(const facade::Rule& rule) {
    if (rule.items.size() != 1) refuse(rule, "it has several items");
    if (rule.guard || rule.weight || !rule.formals.empty())
      refuse(rule, "it has a guard, a weight or parameters");
    return rule.items[0];
  }

  /// A head with a grid rule is a grid of that type.
  void find_grid(const facade::Rule& rule) {
    const facade::Item& item = only_item(rule);
    if (item.kind != facade::ItemKind::split || item.name != "grid") return;
    SymbolInfo& info = out_.symbols[static_cast<size_t>(find(rule.head))];
    const bool regular = flag(item, "regular"), identical = flag(item, "identical");
    if (info.grid && (info.regular != regular || info.identical != identical))
      refuse(rule, "another rule of its head makes a grid of another type");
    info.grid = true;
    info.regular = regular, info.identical = identical;
  }

  void add(const facade::Rule& rule) {
    const facade::Item& item = only_item(rule);
    Production production;
    production.head = find(rule.head);
    for (const facade::Item& part : item.parts) production.parts.push_back(symbol(part));
    production.op = op(rule, item, production);
    const size_t max_parts =
        production.op == Op::rows || production.op == Op::mirror || production.op == Op::windows
            ? 2
            : 1;
    const size_t min_parts = production.op == Op::rows ? 2 : 1;
    if (production.parts.size() < min_parts || production.parts.size() > max_parts)
      refuse(rule, "it has the wrong number of parts");
    out_.productions.push_back(std::move(production));
  }

  Op op(const facade::Rule& rule, const facade::Item& item, Production& production) const {
    if (item.kind == facade::ItemKind::element) {
      production.parts = {symbol(item)};
      return Op::terminal;
    }
    if (item.kind == facade::ItemKind::symbol) {
      production.parts = {symbol(item)};
      if (!out_.symbols[static_cast<size_t>(production.parts[0])].grid)
        refuse(rule, "its right side is not a grid");
      return Op::grid;
    }
    if (item.kind != facade::ItemKind::split) refuse(rule, "it is a value");
    for (const scene::Operand& operand : item.expr->operands)
      if (operand.value->kind == scene::ExprKind::number)
        refuse(rule, "it has sizes or counts, which must be free");
    if (item.name == "rows") return Op::rows;
    if (item.name == "mirror") return Op::mirror;
    if (item.name == "repeat") return flag(item, "alike") ? Op::repeat : Op::elements;
    if (item.name == "grid") return Op::windows;
    refuse(rule, fmt::format("the split '{}' is not supported", item.name));
  }

  const facade::Rules& from_;
  Rules out_;
};

}  // namespace

Rules compile(const facade::Rules& rules) { return Compiler(rules).compile(); }

}  // namespace vug::fit
