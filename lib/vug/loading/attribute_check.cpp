// SPDX-License-Identifier: Apache-2.0
#include <vug/building/rock_weights.h>
#include <vug/cells/transfer_to_mesh.h>
#include <vug/facade/semantics.h>
#include <vug/flora/merge_instances.h>
#include <vug/loading/attribute_check.h>
#include <vug/loading/rock_check.h>
#include <vug/mesh/rock_weights.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::loading {
namespace {

/// The attributes of the meshes of a shot and of its placed scenes.
std::set<std::string> available_attributes(const shot::Shot& shot) {
  std::set<std::string> names;
  for (const shot::CellsPtr& cells : shot::declared_cells(shot))
    names.insert(cells->attribute_names.begin(), cells->attribute_names.end());
  for (const shot::MeshPtr& mesh : shot.meshes) {
    if (mesh->file_mesh)
      for (const mesh::Attribute& each : mesh->file_mesh->attributes) names.insert(each.name);
    const std::vector<std::string> labels = shot::label_names(mesh->labels);
    names.insert(labels.begin(), labels.end());
    if (mesh->elements.empty()) continue;
    const std::vector<std::string> semantic = facade::semantic_names(mesh->elements);
    names.insert(semantic.begin(), semantic.end());
  }
  for (const shot::VolumePtr& volume : shot.volumes)
    for (const std::string& material : building::materials_of(*volume))
      names.insert(mesh::weight_attribute(material));
  for (const shot::PointInstancer& place : shot.instancers) {
    names.insert(flora::kCopyAttribute);
    for (const shot::Model& model : place.of)
      if (model.scene) names.merge(available_attributes(*model.scene));
  }
  if (!names.empty()) names.emplace(mesh::kColour);
  return names;
}

class AttributeChecker {
 public:
  AttributeChecker(const std::set<std::string>& names, std::string file, Diagnostics& diagnostics)
      : names_(names.begin(), names.end()), file_(std::move(file)), diagnostics_(diagnostics) {}

  /// Checks masks and paints that read an attribute.
  void check_expression(const scene::Expr& expr) const {
    if (expr.kind == scene::ExprKind::call && (expr.text == "attribute" || expr.text == "value"))
      check_name(expr);
  }

  /// Checks AOVs "attribute_NAME".
  void check_layer_names(const scene::ExprPtr& expr) const {
    if (expr->kind == scene::ExprKind::text && expr->text.rfind(kLayer, 0) == 0)
      check_name(expr->text.substr(kLayer.size()), expr->where);
    for (const scene::Operand& operand : expr->operands) check_layer_names(operand.value);
  }

 private:
  static constexpr std::string_view kLayer = "attribute_";

  void check_name(const scene::Expr& call) const {
    const scene::Expr* name = nullptr;
    for (const scene::Operand& operand : call.operands) {
      if (operand.name == "otherwise") return;
      if (operand.name == "name" || operand.name.empty()) name = operand.value.get();
    }
    if (name && name->kind == scene::ExprKind::text) check_name(name->text, name->where);
  }

  void check_name(const std::string& name, const SourceLocation& where) const {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) return;
    if (where.file != file_ && nearest_name(name, names_).empty()) return;
    diagnostics_.warning(where, fmt::format("unknown attribute '{}'", name),
                         did_you_mean(name, names_, others()));
  }

  std::string others() const {
    if (names_.empty()) return "cells, stems, leaves, facades and mesh files provide attributes";
    const bool cut = names_.size() > kMaxListed;
    const auto end = names_.begin() + static_cast<std::ptrdiff_t>(cut ? kMaxListed : names_.size());
    return fmt::format("known attributes: {}{}", fmt::join(names_.begin(), end, ", "),
                       cut ? ", ..." : "");
  }

  static constexpr size_t kMaxListed = 20;
  std::vector<std::string> names_;
  std::string file_;  ///< The scene's own text; included texts may serve other scenes.
  Diagnostics& diagnostics_;
};

}  // namespace

void check_attributes(const scene::Document& document, const shot::Shot& shot,
                      Diagnostics& diagnostics) {
  const std::set<std::string> names = available_attributes(shot);
  const AttributeChecker checker(names, document.sources.at(0)->file, diagnostics);
  each_expression(document, [&](const scene::Expr& expr) { checker.check_expression(expr); });
  for (const scene::Declaration& declaration : document.declarations)
    if (const scene::Entry* layers = declaration.find_entry("layers"))
      for (const scene::ExprPtr& value : layers->values) checker.check_layer_names(value);
  std::vector<std::string> rocks;
  for (const std::string& each : names)
    if (const auto rock = mesh::material_of_attribute(each)) rocks.push_back(*rock);
  check_rocks(document, shot, rocks, diagnostics);
}

}  // namespace vug::loading
