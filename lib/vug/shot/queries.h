// Queries on a shot: what it declares, what it shows, and what it has under a name.
#pragma once

#include <vug/shot/cells_plan.h>

#include <string>
#include <vector>

namespace vug::shot {

/// The meshes a shot declares, those without cells left out where another is the same with cells.
std::vector<MeshPtr> declared_meshes(const Shot& shot);

/// The meshes a shot shows or measures: those it declares, else one for each level set.
std::vector<MeshPtr> shown_meshes(const Shot& shot);

/// The cells that a shot declares, in its order; also those that others stand on.
std::vector<CellsPtr> declared_cells(const Shot& shot);

/// The objects that a shot shows where their meshes stand: not those that it places. Of a shot
/// without objects they are its meshes, in grey.
std::vector<ObjectPlan> shown_objects(const Shot& shot);

/// A grey object of the mesh, under its name.
ObjectPlan plain_object(const MeshPtr& mesh);

/// Groups of the lights and shining objects of a shot and of all that it places.
std::vector<std::string> light_groups(const Shot& shot);

/// The attributes that tell its elements apart, those of what it wears cells on too.
std::vector<std::string> element_names(const MeshPlan& plan);

/// Of what a shot shows or measures (see shown_meshes), and of meshes under cells; an empty name
/// takes the first. Error(bad_input), with the nearest name, where there is none.
MeshPtr find_mesh(const Shot& shot, const std::string& name);
/// Likewise of its volumes.
VolumePtr find_volume(const Shot& shot, const std::string& name);
/// Likewise of its cells.
CellsPtr find_cells(const Shot& shot, const std::string& name);

}  // namespace vug::shot
