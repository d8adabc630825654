// A mesh puts on what its cells carry.
#pragma once

#include <vug/session/skin.h>

namespace vug::session {

/// The mesh with what the skin's cells carry at its vertices (see cells/onto_mesh.h), moved and
/// with holes where the plan says so.
mesh::Mesh wear(mesh::Mesh bare, const Skin& skin, const CellsPlan& plan, Progress& progress);

}  // namespace vug::session
