// The mesh of a level set, as a scene asks for it.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/pieces.h>
#include <vug/session/shot.h>
#include <vug/volume/level_set.h>

namespace vug::session {

/// The mesh of the plan's level set, without its small pieces, with vertex colours.
/// Error(too_large) where `memory` bytes do not suffice.
mesh::LargePieces make_mesh(const MeshPlan& plan, const volume::LevelSet& surface, uint64_t memory,
                            Progress& progress);

/// All in one, in their order; what one of them does not carry is 0 there, and without normals of
/// all there are none.
mesh::Mesh merged(const std::vector<mesh::MeshPtr>& parts);

/// Adds the paint's colours at the vertices, which have normals, as attribute Cd.
void add_colors(mesh::Mesh& mesh, const paint::Paint& paint, const volume::LevelSet& surface);

}  // namespace vug::session
