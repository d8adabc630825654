// SPDX-License-Identifier: Apache-2.0
// Queries on a shot: its declared and shown products, and look-up by name.
#pragma once

#include <vug/shot/cells_plan.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::shot {

/// The declared meshes, without those that another mesh covers with cells.
std::vector<MeshPtr> declared_meshes(const Shot& shot);

/// The meshes to show or measure: the declared ones, else one for each level set.
std::vector<MeshPtr> shown_meshes(const Shot& shot);

/// The declared cells in their order, including those below other cells.
std::vector<CellsPtr> declared_cells(const Shot& shot);

/// The objects shown at the position of their meshes, without those that are only instanced. For a
/// shot without objects these are its meshes with the default grey material.
std::vector<ObjectPlan> shown_objects(const Shot& shot);

/// An object with the name of the mesh and the default grey material.
ObjectPlan plain_object(const MeshPtr& mesh);

/// The object of a model, or an object with its mesh; nothing for a scene.
std::optional<ObjectPlan> object_of(const Shot& shot, const Model& model);

/// The light groups of all lights and emissive objects, including those of placed scenes.
std::vector<std::string> light_groups(const Shot& shot);

/// The attributes that identify the facade elements and labels of the mesh, including those of the
/// mesh below its cells.
std::vector<std::string> element_names(const MeshPlan& plan);

/// Whether components of the mesh may penetrate each other: stems do where they branch, and leaves.
bool components_may_overlap(const MeshPtr& mesh);

/// The mesh of that name among shown_meshes and the meshes below cells; the first one for an empty
/// name. Error(bad_input) with the nearest name if there is no such mesh.
MeshPtr find_mesh(const Shot& shot, const std::string& name);
/// The volume of that name; the first one for an empty name. Error(bad_input) as find_mesh.
VolumePtr find_volume(const Shot& shot, const std::string& name);
/// The cells of that name; the first ones for an empty name. Error(bad_input) as find_mesh.
CellsPtr find_cells(const Shot& shot, const std::string& name);
/// The network of that name; the first one for an empty name. Error(bad_input) as find_mesh. The
/// result is an element of the shot.
const NetworkPlan& find_network(const Shot& shot, const std::string& name);
/// The drips of that name; the first ones for an empty name. Error(bad_input) as find_mesh. The
/// result is an element of the shot.
const NamedDrips& find_drips(const Shot& shot, const std::string& name);

}  // namespace vug::shot
