// The mesh of a level set or of a file, as a scene asks for it.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/components.h>
#include <vug/shot/shot.h>
#include <vug/volume/level_set.h>

namespace vug::building {

/// The mesh of the plan's level set, without its small pieces, with vertex colours and
/// what tells elements of facades apart.
/// Error(too_large) where `memory` bytes do not suffice.
mesh::LargeComponents make_mesh(const shot::MeshPlan& plan, const volume::LevelSet& surface,
                                uint64_t memory, Progress& progress);

/// The same of what the plan's file holds.
mesh::LargeComponents make_mesh(const shot::MeshPlan& plan);

/// All in one, in their order; what one of them does not carry is 0 there, and without normals of
/// all there are none.
mesh::Mesh merge_meshes(const std::vector<mesh::MeshPtr>& parts);

/// Adds the paint's colours at the vertices, which have normals, as attribute Cd; `solid` is the
/// level set whose surface it is, or null.
void add_colors(mesh::Mesh& mesh, const paint::Paint& paint, const field::SampledGrid* solid);

/// With triangles no larger than the plan's cells. Error(too_large) at its spacing.
mesh::MeshPtr refine_for_cells(const shot::CellsPlan& plan, const mesh::Mesh& mesh,
                               uint64_t memory);

}  // namespace vug::building
