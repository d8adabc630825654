#include <vug/cells/transfer_to_mesh.h>
#include <vug/facade/semantics.h>
#include <vug/flora/merged.h>
#include <vug/loading/attribute_check.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::loading {
namespace {

/// What the meshes of a shot carry, and those of the scenes that stand in it.
std::set<std::string> carried(const shot::Shot& shot) {
  std::set<std::string> names;
  for (const shot::CellsPtr& cells : shot::declared_cells(shot))
    names.insert(cells->brings.begin(), cells->brings.end());
  for (const shot::MeshPtr& mesh : shot.meshes) {
    if (mesh->given)
      for (const mesh::Attribute& each : mesh->given->attributes) names.insert(each.name);
    if (mesh->elements.empty()) continue;
    const std::vector<std::string> semantic = facade::semantic_names(mesh->elements);
    names.insert(semantic.begin(), semantic.end());
  }
  for (const shot::PlacePlan& place : shot.places) {
    names.insert(flora::kCopy);
    for (const shot::Model& model : place.of)
      if (model.scene) names.merge(carried(*model.scene));
  }
  if (!names.empty()) names.emplace(mesh::kColour);
  return names;
}

class Search {
 public:
  Search(const std::set<std::string>& names, std::string file, Diagnostics& diagnostics)
      : names_(names.begin(), names.end()), file_(std::move(file)), diagnostics_(diagnostics) {}

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
    if (near.empty() && where.file != file_) return;
    diagnostics_.warning(where, fmt::format("nobody brings an attribute '{}'", name),
                         near.empty() ? others() : fmt::format("did you mean '{}'?", near));
  }

  std::string others() const {
    if (names_.empty()) return "cells, stems, leaves, facades and files of meshes bring some";
    const bool cut = names_.size() > kMostTold;
    const auto end = names_.begin() + static_cast<std::ptrdiff_t>(cut ? kMostTold : names_.size());
    return fmt::format("there are {}{}", fmt::join(names_.begin(), end, ", "), cut ? ", ..." : "");
  }

  static constexpr size_t kMostTold = 20;
  std::vector<std::string> names_;
  std::string file_;  ///< The scene's own text: what it includes may be made for other scenes, too.
  Diagnostics& diagnostics_;
};

}  // namespace

void warn_of_misspelt_attributes(const scene::Document& document, const shot::Shot& shot,
                                 Diagnostics& diagnostics) {
  const Search search(carried(shot), document.sources.at(0)->file, diagnostics);
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

}  // namespace vug::loading
