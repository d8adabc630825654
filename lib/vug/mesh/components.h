// Crumbs and closed bubbles taken out of a mesh.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

struct LargeComponents {
  Mesh mesh;
  size_t removed = 0;  ///< Pieces.
};

/// The mesh without its pieces (joined along edges) whose bounding box has a diagonal below
/// `smallest` metres: crumbs afloat as well as bubbles inside a solid. The largest piece stays
/// whatever its size. What stays keeps its order, normals and attributes. With 0 the mesh comes
/// back as it is.
LargeComponents large_components(Mesh mesh, double smallest);

}  // namespace vug::mesh
