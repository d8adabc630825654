// What a shot has under a name.
#pragma once

#include <vug/session/cells_plan.h>

#include <string>

namespace vug::session {

/// Of what a shot shows or measures (see meshes_of), and of meshes under cells; an empty name takes
/// the first.
/// Error(bad_input), with the nearest name, where there is none.
MeshPtr find_mesh(const Shot& shot, const std::string& name);
/// Likewise of its volumes.
VolumePtr find_volume(const Shot& shot, const std::string& name);
/// Likewise of its cells.
CellsPtr find_cells(const Shot& shot, const std::string& name);

}  // namespace vug::session
