// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/shot/queries.h>
#include <vug/shot/selection.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace vug::shot {
namespace {

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The name of the declaration: "lamp" for the element "lamp[2]" of a loop.
std::string without_index(const std::string& name) {
  return name.ends_with(']') ? name.substr(0, name.rfind('[')) : name;
}

/// Whether the names select a thing: by its name or by that of all elements of its loop.
bool are_selecting(const Names& names, const std::string& name) {
  return contains(names, name) || contains(names, without_index(name));
}

/// Whether the name selects one of the things.
bool selects_any(const std::string& name, const Names& known) {
  return std::any_of(known.begin(), known.end(), [&](const std::string& each) {
    return each == name || without_index(each) == name;
  });
}

Names light_names(const Shot& shot) {
  Names names;
  for (const auto& [name, light] : shot.lights) names.push_back(name);
  return names;
}

Names medium_names(const Shot& shot) {
  Names names;
  for (const MediumPlan& each : shot.media) names.push_back(each.name);
  return names;
}

/// Why an object of that name cannot be selected, or a similar name.
std::string object_hint(const Shot& shot, const std::string& name, const Names& known) {
  for (const PointInstancer& place : shot.instancers)
    for (const Model& model : place.of)
      if (model.name == name)
        return fmt::format("as an instance, '{}' is selected by the name of its place: '{}'", name,
                           place.name);
  return suggestion(name, known);
}

/// Adds the volumes of a mesh and of all meshes that it depends on.
void add_volumes(const MeshPtr& mesh, std::set<VolumePtr>& volumes) {
  if (mesh->volume) {
    volumes.insert(mesh->volume);
    if (mesh->volume->source_mesh) add_volumes(mesh->volume->source_mesh, volumes);
  }
  for (const MeshPtr& part : mesh->parts) add_volumes(part, volumes);
  if (!mesh->cells) return;
  for (const MeshPtr& support : mesh->cells->on) add_volumes(support, volumes);
}

/// Reduces the part to the selected objects and places, and to what these need.
void select_objects(const Shot& shot, const Names& names, Shot& part) {
  part.instancers.clear(), part.objects.clear(), part.meshes.clear(), part.volumes.clear();
  std::copy_if(shot.instancers.begin(), shot.instancers.end(), std::back_inserter(part.instancers),
               [&](const PointInstancer& each) { return are_selecting(names, each.name); });
  Names placed;
  std::vector<MeshPtr> meshes;
  for (const PointInstancer& place : part.instancers)
    for (const Model& model : place.of) {
      if (model.mesh) meshes.push_back(model.mesh);
      if (!model.mesh && !model.scene) placed.push_back(model.name);
    }
  for (const ObjectPlan& object : shown_objects(shot))
    if (are_selecting(names, object.name)) part.objects.push_back(object);
  for (const ObjectPlan& object : shot.objects)
    if (contains(placed, object.name)) part.objects.push_back(object);
  for (const ObjectPlan& object : part.objects) meshes.push_back(object.mesh);
  std::set<VolumePtr> volumes;
  for (const MeshPtr& mesh : meshes) {
    if (std::find(part.meshes.begin(), part.meshes.end(), mesh) == part.meshes.end())
      part.meshes.push_back(mesh);
    add_volumes(mesh, volumes);
  }
  std::copy_if(shot.volumes.begin(), shot.volumes.end(), std::back_inserter(part.volumes),
               [&](const VolumePtr& each) { return volumes.count(each) > 0; });
}

/// The shot without its derivations, which pictures do not need and which may be large.
Shot without_derivations(const Shot& shot) {
  Shot part;
  part.name = shot.name, part.seed = shot.seed, part.frame = shot.frame;
  part.animated = shot.animated, part.draft = shot.draft;
  part.recipe = shot.recipe, part.text_digest = shot.text_digest;
  part.volumes = shot.volumes, part.meshes = shot.meshes, part.objects = shot.objects;
  part.instancers = shot.instancers, part.cameras = shot.cameras, part.lights = shot.lights;
  part.media = shot.media, part.materials = shot.materials, part.renders = shot.renders;
  return part;
}

}  // namespace

Names selectable_objects(const Shot& shot) {
  Names names;
  const auto add = [&](const std::string& name) {
    if (!contains(names, name)) names.push_back(name);
  };
  for (const ObjectPlan& object : shown_objects(shot)) add(object.name);
  for (const PointInstancer& place : shot.instancers) add(place.name);
  return names;
}

std::vector<SelectionFault> find_selection_faults(const Shot& shot,
                                                  const RenderSettings& settings) {
  std::vector<SelectionFault> faults;
  const auto unknown = [&](const char* setting, const std::string& name, const char* what,
                           const std::string& hint) {
    faults.push_back({setting, name, fmt::format("the scene has no {} '{}'", what, name), hint});
  };
  const Names lights = light_names(shot), objects = selectable_objects(shot);
  Names media = medium_names(shot);
  for (const std::string& name : settings.lights.value_or(Names()))
    if (!selects_any(name, lights)) unknown("lights", name, "light", suggestion(name, lights));
  for (const std::string& name : settings.objects.value_or(Names()))
    if (!selects_any(name, objects))
      unknown("objects", name, "object or place", object_hint(shot, name, objects));
  if (settings.air.empty() && media.size() > 1)
    faults.push_back({"air", "",
                      fmt::format("the scene has several media: {}", fmt::join(media, ", ")),
                      fmt::format("choose one in the render block, 'air {}', or write 'air {}'",
                                  media[0], kNoAir)});
  media.push_back(kNoAir);
  if (!settings.air.empty() && !contains(media, settings.air))
    unknown("air", settings.air, "medium", suggestion(settings.air, media));
  return faults;
}

const MediumPlan* find_air(const Shot& shot, const RenderSettings& settings) {
  if (settings.air.empty()) return shot.media.size() == 1 ? &shot.media.front() : nullptr;
  for (const MediumPlan& each : shot.media)
    if (each.name == settings.air) return &each;
  return nullptr;
}

std::shared_ptr<const Shot> selected_part(const Shot& shot, const RenderSettings& settings) {
  const MediumPlan* air = find_air(shot, settings);
  const bool other_air = shot.media.size() != (air ? 1u : 0u);
  if (!settings.lights && !settings.objects && !other_air)
    return {std::shared_ptr<const Shot>(), &shot};
  auto part = std::make_shared<Shot>(without_derivations(shot));
  if (settings.lights)
    std::erase_if(part->lights,
                  [&](const auto& each) { return !are_selecting(*settings.lights, each.first); });
  if (settings.objects) select_objects(shot, *settings.objects, *part);
  part->media.clear();
  if (air) part->media.push_back(*air);
  return part;
}

Names omitted_objects(const Shot& shot, const Shot& part) {
  const Names kept = selectable_objects(part);
  Names names = selectable_objects(shot);
  std::erase_if(names, [&](const std::string& name) { return contains(kept, name); });
  return names;
}

}  // namespace vug::shot
