// A mesh puts on what its cells carry.
#pragma once

#include <vug/building/cell_layer.h>

namespace vug::building {

struct MeshWithCells {
  mesh::Mesh mesh;
  size_t flipped_triangles = 0;  ///< Triangles whose other side shows since it was moved.
};

/// The mesh with what the skin's cells carry at its vertices (see cells/transfer_to_mesh.h), moved
/// and with holes where the plan says so. Error(bad_input) at the plan's name where it would be
/// moved by more than ten times its own size.
MeshWithCells apply_cells(const mesh::Mesh& bare, const CellLayer& layer,
                          const shot::CellsPlan& plan, Progress& progress);

}  // namespace vug::building
