// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/semantics.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace vug::shot {
namespace {

/// `how`: an example declaration for the hint.
template <class Plans>
typename Plans::value_type find_named(const Plans& plans, const std::string& name,
                                      const std::string& what, const std::string& how) {
  std::vector<std::string> names;
  for (const auto& plan : plans) {
    if (name.empty() || plan->name == name) return plan;
    names.push_back(plan->name);
  }
  if (names.empty() && name.empty())
    throw Error(ErrorCode::bad_input, fmt::format("the scene has no {}", what), {},
                "add for instance: " + how);
  throw Error(ErrorCode::bad_input, fmt::format("the scene has no {} '{}'", what, name), {},
              names.empty() ? "add for instance: " + how : suggestion(name, names));
}

constexpr const char* kVolume = "volume rock = level_set(..., voxel: 5cm)";

}  // namespace

std::vector<MeshPtr> declared_meshes(const Shot& shot) {
  std::set<MeshPtr> bare;
  for (const MeshPtr& mesh : shot.meshes)
    if (mesh->cells) bare.insert(mesh->cells->on.begin(), mesh->cells->on.end());
  std::vector<MeshPtr> kept;
  std::copy_if(shot.meshes.begin(), shot.meshes.end(), std::back_inserter(kept),
               [&](const MeshPtr& mesh) { return bare.count(mesh) == 0; });
  return kept;
}

std::vector<MeshPtr> shown_meshes(const Shot& shot) {
  if (!shot.meshes.empty()) return declared_meshes(shot);
  std::vector<MeshPtr> meshes;
  for (const VolumePtr& volume : shot.volumes) {
    if (volume->fog) continue;
    meshes.push_back(plain_mesh(volume));
  }
  return meshes;
}

std::vector<CellsPtr> declared_cells(const Shot& shot) {
  std::vector<CellsPtr> out;
  for (const MeshPtr& mesh : shot.meshes)
    if (mesh->cells && std::find(out.begin(), out.end(), mesh->cells) == out.end())
      out.push_back(mesh->cells);
  return out;
}

ObjectPlan plain_object(const MeshPtr& mesh) {
  ObjectPlan plan;
  plan.name = mesh->name;
  plan.mesh = mesh;
  return plan;
}

std::optional<ObjectPlan> object_of(const Shot& shot, const Model& model) {
  if (model.mesh) return plain_object(model.mesh);
  if (model.scene) return std::nullopt;
  for (const ObjectPlan& object : shot.objects)
    if (object.name == model.name) return object;
  return std::nullopt;
}

std::vector<ObjectPlan> shown_objects(const Shot& shot) {
  const auto is_placed = [&](const std::string& name, const MeshPtr& mesh) {
    for (const PointInstancer& plan : shot.instancers)
      for (const Model& model : plan.of)
        if (mesh ? model.mesh == mesh : !model.scene && !model.mesh && model.name == name)
          return true;
    return false;
  };
  std::vector<ObjectPlan> shown;
  for (const ObjectPlan& object : shot.objects)
    if (!is_placed(object.name, nullptr)) shown.push_back(object);
  if (!shot.objects.empty()) return shown;
  for (const MeshPtr& mesh : shown_meshes(shot))
    if (!is_placed(mesh->name, mesh)) shown.push_back(plain_object(mesh));
  return shown;
}

std::vector<std::string> light_groups(const Shot& shot) {
  std::vector<std::string> groups;
  for (const auto& [name, light] : shot.lights) groups.push_back(light->linking().group);
  for (const ObjectPlan& object : shot.objects) groups.push_back(object.light_group);
  for (const PointInstancer& plan : shot.instancers)
    for (const Model& model : plan.of) {
      if (!model.scene) continue;
      const std::vector<std::string> more = light_groups(*model.scene);
      groups.insert(groups.end(), more.begin(), more.end());
    }
  return groups;
}

std::vector<std::string> element_names(const MeshPlan& plan) {
  std::vector<std::string> names = facade::element_names(plan.elements);
  const std::vector<std::string> labels = label_names(plan.labels);
  names.insert(names.end(), labels.begin(), labels.end());
  const auto add = [&](const MeshPtr& other) {
    const std::vector<std::string> more = element_names(*other);
    names.insert(names.end(), more.begin(), more.end());
  };
  for (const MeshPtr& part : plan.parts) add(part);
  if (const MeshPtr under = mesh_without_cells(plan)) add(under);
  return names;
}

bool components_may_overlap(const MeshPtr& mesh) {
  for (const MeshPtr& part : parts_of(mesh))
    for (MeshPtr each = part; each; each = mesh_without_cells(*each))
      if (each->drawn) return true;
  return false;
}

MeshPtr find_mesh(const Shot& shot, const std::string& name) {
  std::vector<MeshPtr> meshes = shown_meshes(shot);
  for (const MeshPtr& mesh : shot.meshes)
    if (std::find(meshes.begin(), meshes.end(), mesh) == meshes.end()) meshes.push_back(mesh);
  return find_named(meshes, name, "mesh", kVolume);
}

VolumePtr find_volume(const Shot& shot, const std::string& name) {
  return find_named(shot.volumes, name, "volume", kVolume);
}

const NetworkPlan& find_network(const Shot& shot, const std::string& name) {
  std::vector<const NetworkPlan*> networks;
  for (const NetworkPlan& plan : shot.networks) networks.push_back(&plan);
  return *find_named(networks, name, "network", "network plan = karst(preset: branchwork)");
}

const NamedDrips& find_drips(const Shot& shot, const std::string& name) {
  std::vector<const NamedDrips*> drips;
  for (const NamedDrips& each : shot.drips) drips.push_back(&each);
  return *find_named(drips, name, "drips", "drips water = seepage(rock, from: ..., to: ...)");
}

CellsPtr find_cells(const Shot& shot, const std::string& name) {
  return find_named(declared_cells(shot), name, "cells", "cells NAME on MESH { ... }");
}

}  // namespace vug::shot
