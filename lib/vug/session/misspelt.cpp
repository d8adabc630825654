#include <vug/cells/onto_mesh.h>
#include <vug/facade/semantics.h>
#include <vug/session/cells_files.h>
#include <vug/session/cells_plan.h>
#include <vug/session/misspelt.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::session {
namespace {

std::vector<std::string> carried(const Shot& shot) {
  std::vector<std::string> names;
  for (const CellsPtr& cells : declared_cells(shot))
    names.insert(names.end(), cells->brings.begin(), cells->brings.end());
  for (const MeshPtr& mesh : shot.meshes) {
    if (mesh->given)
      for (const mesh::Attribute& each : mesh->given->attributes) names.push_back(each.name);
    if (mesh->elements.empty()) continue;
    const std::vector<std::string> semantic = facade::semantic_names(mesh->elements);
    names.insert(names.end(), semantic.begin(), semantic.end());
  }
  if (!names.empty()) names.emplace_back(mesh::kColour);
  return names;
}

class Search {
 public:
  Search(const std::vector<std::string>& names, Diagnostics& diagnostics)
      : names_(names), diagnostics_(diagnostics) {}

  /// For masks and paints that read an attribute.
  void look(const scene::ExprPtr& expr) const {
    if (!expr) return;
    if (expr->kind == scene::ExprKind::call && (expr->text == "attribute" || expr->text == "value"))
      judge(*expr);
    for (const scene::Operand& operand : expr->operands) look(operand.value);
  }

  /// For layers "attribute_NAME".
  void look_at_layers(const scene::ExprPtr& expr) const {
    if (expr->kind == scene::ExprKind::text && expr->text.rfind(kLayer, 0) == 0)
      judge(expr->text.substr(kLayer.size()), expr->where);
    for (const scene::Operand& operand : expr->operands) look_at_layers(operand.value);
  }

 private:
  static constexpr std::string_view kLayer = "attribute_";

  void judge(const scene::Expr& call) const {
    const scene::Expr* name = nullptr;
    for (const scene::Operand& operand : call.operands) {
      if (operand.name == "otherwise") return;
      if (operand.name == "name" || operand.name.empty()) name = operand.value.get();
    }
    if (name && name->kind == scene::ExprKind::text) judge(name->text, name->where);
  }

  void judge(const std::string& name, const SourceLocation& where) const {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) return;
    const std::string near = nearest_name(name, names_);
    if (near.empty()) return;
    diagnostics_.warning(where, fmt::format("nobody brings an attribute '{}'", name),
                         fmt::format("did you mean '{}'?", near));
  }

  const std::vector<std::string>& names_;
  Diagnostics& diagnostics_;
};

}  // namespace

void warn_of_misspelt_attributes(const scene::Document& document, const Shot& shot,
                                 Diagnostics& diagnostics) {
  const std::vector<std::string> names = carried(shot);
  if (names.empty()) return;
  const Search search(names, diagnostics);
  for (const scene::Let& let : document.lets) search.look(let.value);
  for (const scene::Declaration& declaration : document.declarations) {
    search.look(declaration.value);
    if (const scene::Entry* layers = declaration.find_entry("layers"))
      for (const scene::ExprPtr& value : layers->values) search.look_at_layers(value);
    for (const scene::Entry& entry : declaration.entries)
      if (declaration.kind != "cells")  // told as errors
        for (const scene::ExprPtr& value : entry.values) search.look(value);
  }
}

}  // namespace vug::session
