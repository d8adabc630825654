// A mesh puts on what its cells carry.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/mesh.h>
#include <vug/session/cells_plan.h>
#include <vug/volume/level_set.h>

namespace vug::session {

/// Makes the network on the mesh, runs its rules and adds what the cells carry to the vertices; see
/// cells/onto_mesh.h. `solid` is the level set whose surface the mesh is, for masks. Errors of the
/// spacing are told where the text gives it; Error(too_large) where `memory` bytes do not suffice.
void wear(mesh::Mesh& mesh, const CellsPlan& plan, const volume::LevelSet& solid, uint64_t memory,
          Progress& progress);

}  // namespace vug::session
