// What cells carry, at the vertices of a mesh: smooth from cell to cell.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/simulation.h>
#include <vug/mesh/mesh.h>

namespace vug::cells {

/// Attributes that move a surface: where cells are now, and metres along the surface's normal.
inline constexpr std::string_view kPlace = "P";
inline constexpr std::string_view kHeight = "height";

struct TransferOptions {
  bool move = false;  ///< Take the mesh's vertices along where kPlace and kHeight say so.
};

/// Adds every attribute of the simulation's cells (but "P" and "N") and kTransparent to the mesh,
/// in place of those of the same name.
///
/// A vertex gets the mean over the cells nearer than the reach, a Shepard mean with weights
/// (1 - d²/r²)² max(0, n·n')²: they and their slopes fall to 0 at the reach r and where the normals
/// n stand across each other, so neither facets show nor the far side of a thin wall. r is the
/// network's reach, or the mean edge of a mesh that is coarser, so that no cell is passed over;
/// around a vertex that no cell is near, as where a normal points astray, it is doubled until
/// there is one. A mean lies between what it is taken of: what is the same in all cells stays so
/// exactly, and a function of slope g is met within g r.
///
/// Vertices move by the mean way of the cells around them, as far as these have gone, and by the
/// mean height along their own normal; normals turn as the triangles around them do.
/// Error(bad_input) where a vertex would not go to a place that is finite.
///
/// Cells without colour (Cd of 0) count with the colour that the mesh has at the vertex.
void transfer_to_mesh(const Simulation& simulation, mesh::Mesh& mesh,
                      const TransferOptions& options = {}, Progress& progress = Progress::none());

}  // namespace vug::cells
