// SPDX-License-Identifier: Apache-2.0
#include <vug/building/rock_weights.h>
#include <vug/field/assigned_materials.h>
#include <vug/loading/rock_check.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_set>

namespace vug::loading {
namespace {

using scene::Declaration;
using scene::Document;
using scene::Expr;
using scene::ExprKind;
using scene::ExprPtr;
using scene::Operand;

void visit_tree(const ExprPtr& expr, const std::function<void(const Expr&)>& visit) {
  if (!expr) return;
  visit(*expr);
  for (const Operand& operand : expr->operands) visit_tree(operand.value, visit);
}

bool has_name(const std::vector<std::string>& all, const std::string& name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

bool is_table(const Expr& expr) { return expr.kind == ExprKind::call && expr.text == "by_rock"; }

/// The names of a table, as far as the text contains them.
std::vector<const Expr*> names_of(const Expr& table) {
  std::vector<const Expr*> out;
  for (const Operand& operand : table.operands)
    if (operand.name == "of" || (operand.name.empty() && &operand == &table.operands.front()))
      for (const Operand& each : operand.value->operands)
        if (each.value->kind == ExprKind::text) out.push_back(each.value.get());
  return out;
}

/// Whether the table has a material for each rock that it does not name, or may have one.
bool is_complete(const Expr& table) {
  return std::any_of(table.operands.begin(), table.operands.end(), [](const Operand& operand) {
    return operand.name == "otherwise" ||
           (operand.name == "of" && operand.value->kind != ExprKind::list);
  });
}

/// The table that is the material of an object, also by the name of a declared material.
const Expr* table_of(const Document& document, const Declaration& object) {
  const scene::Entry* material = object.find_entry("material");
  if (!material || material->values.empty()) return nullptr;
  const Expr* expr = material->values.front().get();
  if (expr->kind == ExprKind::name)
    for (const Declaration& each : document.declarations)
      if (each.kind == "material" && each.name == scene::full_name(*expr) && each.value)
        expr = each.value.get();
  return is_table(*expr) ? expr : nullptr;
}

/// The declaration of an object; null for one that the text does not declare itself.
const Declaration* declaration_of(const Document& document, const shot::ObjectPlan& object) {
  for (const Declaration& each : document.declarations)
    if (each.kind == "object" && each.where.file == object.where.file &&
        each.where.line == object.where.line && each.where.column == object.where.column)
      return &each;
  return nullptr;
}

/// Two materials of a field that have the same name and different hardnesses.
struct MaterialConflict {
  field::RockMaterialPtr first, second;
};

std::optional<MaterialConflict> conflict_in(const field::Field& rock) {
  std::map<std::string, field::RockMaterialPtr> known;
  for (const field::RockMaterialPtr& each : field::assigned_materials(rock))
    if (const auto [place, added] = known.emplace(each->name, each);
        !added && place->second->hardness != each->hardness)
      return MaterialConflict{place->second, each};
  return std::nullopt;
}

/// The last call in the text that declares the rock material of that name; `otherwise` if none
/// does.
SourceLocation place_of_material(const Document& document, const std::string& name,
                                 const SourceLocation& otherwise) {
  SourceLocation where = otherwise;
  each_expression(document, [&](const Expr& expr) {
    if (expr.kind != ExprKind::call || expr.text != "rock_material") return;
    for (const Operand& operand : expr.operands)
      if ((operand.name == "name" || operand.name.empty()) && operand.value &&
          operand.value->kind == ExprKind::text && operand.value->text == name)
        where = expr.where;
  });
  return where;
}

/// Reports materials that a rock has with two hardnesses, each name once.
void check_hardnesses(const Document& document, const shot::Shot& shot, Diagnostics& diagnostics) {
  std::unordered_set<std::string> reported;
  for (const shot::VolumePtr& volume : shot.volumes) {
    if (volume->source_mesh) continue;
    const std::optional<MaterialConflict> conflict = conflict_in(volume->field);
    if (!conflict || !reported.insert(conflict->first->name).second) continue;
    const std::string& name = conflict->first->name;
    const auto [low, high] = std::minmax(conflict->first->hardness, conflict->second->hardness);
    diagnostics.error(
        place_of_material(document, name, volume->where),
        fmt::format("the rock material '{}' of '{}' has two hardnesses, {:g} % and {:g} %", name,
                    volume->name, 100 * low, 100 * high),
        "declare it once, 'let NAME = rock_material(...)', and use it everywhere; a text is a "
        "material of hardness 0");
  }
}

class RockChecker {
 public:
  RockChecker(const Document& document, const std::vector<std::string>& rocks,
              Diagnostics& diagnostics)
      : document_(document), rocks_(rocks), diagnostics_(diagnostics) {}

  void check_name(const Expr& name) const {
    if (has_name(rocks_, name.text)) return;
    const std::string hint = did_you_mean(
        name.text, rocks_,
        rocks_.empty() ? fmt::format("made_of(FIELD, of: \"{}\") and host_rock assign "
                                     "materials",
                                     name.text)
                       : fmt::format("the rocks of the scene are {}", fmt::join(rocks_, ", ")));
    const std::string message = fmt::format("no rock is made of '{}'", name.text);
    if (is_own(name.where) && !rocks_.empty())
      diagnostics_.error(name.where, message, hint);
    else if (is_own(name.where) || !nearest_name(name.text, rocks_).empty())
      diagnostics_.warning(name.where, message, hint);
  }

  void check_object(const shot::ObjectPlan& object) const {
    const Declaration* declared = declaration_of(document_, object);
    const Expr* table = declared ? table_of(document_, *declared) : nullptr;
    if (!table || is_complete(*table) || !is_own(table->where) || !object.mesh->volume) return;
    std::vector<std::string> named;
    for (const Expr* name : names_of(*table)) named.push_back(name->text);
    for (const std::string& rock : building::materials_of(*object.mesh->volume))
      if (!has_name(named, rock))
        diagnostics_.error(
            table->where, fmt::format("'{}' has no material for its rock '{}'", object.name, rock),
            fmt::format("add '{} -> MATERIAL', or 'otherwise -> MATERIAL' for all other rocks",
                        rock));
  }

 private:
  bool is_own(const SourceLocation& where) const {
    return where.file == document_.sources.at(0)->file;
  }

  const Document& document_;
  const std::vector<std::string>& rocks_;
  Diagnostics& diagnostics_;
};

}  // namespace

void each_expression(const Document& document, const std::function<void(const Expr&)>& visit) {
  for (const scene::Let& let : document.lets) visit_tree(let.value, visit);
  for (const scene::Def& def : document.defs) visit_tree(def.body, visit);
  for (const Declaration& declaration : document.declarations) {
    visit_tree(declaration.value, visit);
    if (declaration.kind == "cells") continue;
    for (const scene::Entry& entry : declaration.entries)
      for (const ExprPtr& value : entry.values) visit_tree(value, visit);
  }
}

void check_rocks(const Document& document, const shot::Shot& shot,
                 const std::vector<std::string>& rocks, Diagnostics& diagnostics) {
  const RockChecker checker(document, rocks, diagnostics);
  each_expression(document, [&](const Expr& expr) {
    if (!is_table(expr)) return;
    for (const Expr* name : names_of(expr)) checker.check_name(*name);
  });
  for (const shot::ObjectPlan& object : shot.objects) checker.check_object(object);
  check_hardnesses(document, shot, diagnostics);
}

}  // namespace vug::loading
