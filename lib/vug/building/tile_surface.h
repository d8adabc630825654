// SPDX-License-Identifier: Apache-2.0
// The mesh of a plan in one tile of the lattice.
#pragma once

#include <vug/base/progress.h>
#include <vug/meshing/tile_mesh.h>
#include <vug/shot/shot.h>
#include <vug/volume/level_set.h>

namespace vug::building {

/// The triangles of the plan's mesh in the tile, with all of their components, and with the
/// attributes that each vertex has on its own: normals, elements of facades, labels and the weights
/// of the rock. `surface` is the level set of the tile and of the apron around it; see
/// meshing::kMeshApron. `field` is the volume's field with the faces of its region. The plan has a
/// volume of a field and no cells; its adaptivity has no effect.
meshing::TileMesh make_tile_mesh(const shot::MeshPlan& plan, const volume::LevelSet& surface,
                                 const field::Field& field, const volume::LatticeBox& tile,
                                 Progress& progress);

}  // namespace vug::building
