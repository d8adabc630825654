// SPDX-License-Identifier: Apache-2.0
// Interpolates cell attributes at the vertices of a mesh, and moves the vertices.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/simulation.h>
#include <vug/mesh/mesh.h>

namespace vug::cells {

/// Attributes that move a surface: current positions, and metres along the surface normal.
inline constexpr std::string_view kPlace = "P";
inline constexpr std::string_view kHeight = "height";

struct TransferOptions {
  bool move = false;   ///< Move the mesh's vertices according to kPlace and kHeight.
  bool folds = false;  ///< Allow displacements to fold triangles or to make them intersect.
};

/// Adds every attribute of the simulation's cells (except "P" and "N") and kTransparent to the
/// mesh, replacing those of the same name.
///
/// A vertex gets a Shepard mean over the cells within the reach, with weights (1 - d²/r²)² max(0,
/// n·n')². The weights and their derivatives vanish at the reach r and where the normals n are
/// perpendicular, so neither facets nor the far side of a thin wall show. r is the network's
/// reach, or the mean edge length of a coarser mesh, so that no cell is skipped. It is doubled
/// around a vertex without cells, for example with a wrong normal, until there is one. The mean
/// lies between its inputs: constants are reproduced exactly, and a function of slope g with an
/// error of at most g r.
///
/// Vertices move by the mean displacement of the surrounding cells and by the mean height along
/// their own normal. Where this would fold triangles, displacements are smoothed, and where sheets
/// of the surface would intersect, they are shortened (see mesh/displacement.h); the number of
/// these vertices is returned, and `folds` turns that off. Normals rotate like the surrounding
/// triangles. Throws Error(bad_input) if the new position of a vertex would not be finite.
///
/// Cells without colour (Cd of 0) contribute the mesh's colour at the vertex.
size_t transfer_to_mesh(const Simulation& simulation, mesh::Mesh& mesh,
                        const TransferOptions& options = {}, Progress& progress = Progress::none());

}  // namespace vug::cells
