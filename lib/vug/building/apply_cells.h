// SPDX-License-Identifier: Apache-2.0
// Applies a cell layer to a mesh: calls cells/transfer_to_mesh.h, rejects huge displacements and
// cuts holes.
#pragma once

#include <vug/building/cell_layer.h>

namespace vug::building {

/// Whether displacements may fold the mesh. Folds are harmless in a mesh that becomes a volume.
enum class Folds { prevent, allow };

/// A mesh after the transfer.
struct MeshWithCells {
  mesh::Mesh mesh;
  size_t unfolded_vertices = 0;  ///< Vertices whose displacement was changed to prevent folds and
                                 ///< intersections.
};

/// The mesh with the interpolated attributes of the layer's cells at its vertices (see
/// cells/transfer_to_mesh.h), displaced and with holes if the plan requests it. Error(bad_input),
/// located at the plan's name, for a displacement of more than ten times the size of the mesh.
MeshWithCells apply_cells(const mesh::Mesh& bare, const CellLayer& layer,
                          const shot::CellsPlan& plan, Folds folds, Progress& progress);

}  // namespace vug::building
