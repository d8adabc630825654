#include <vug/session/build.h>
#include <vug/session/cells_files.h>
#include <vug/session/find.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::session {
namespace {

/// `how` is an example of what declares one.
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

MeshPtr find_mesh(const Shot& shot, const std::string& name) {
  std::vector<MeshPtr> meshes = meshes_of(shot);
  for (const MeshPtr& mesh : shot.meshes)
    if (std::find(meshes.begin(), meshes.end(), mesh) == meshes.end()) meshes.push_back(mesh);
  return find_named(meshes, name, "mesh", kVolume);
}

VolumePtr find_volume(const Shot& shot, const std::string& name) {
  return find_named(shot.volumes, name, "volume", kVolume);
}

CellsPtr find_cells(const Shot& shot, const std::string& name) {
  return find_named(declared_cells(shot), name, "cells", "cells NAME on MESH { ... }");
}

}  // namespace vug::session
