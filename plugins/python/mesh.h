// Meshes as Python holds them.
#pragma once

#include "binding.h"

#include <vug/mesh/comments.h>
#include <vug/mesh/mesh.h>

namespace vug::python {

/// Immutable; its arrays share what it points to.
struct Mesh {
  mesh::MeshPtr mesh;
  mesh::Comments notes = {};  ///< That files of it keep.
};

}  // namespace vug::python
