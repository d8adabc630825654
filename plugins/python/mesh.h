// SPDX-License-Identifier: Apache-2.0
// Meshes, as seen from Python.
#pragma once

#include "binding.h"

#include <vug/mesh/comments.h>
#include <vug/mesh/mesh.h>

namespace vug::python {

/// An immutable mesh. Its arrays share the memory that it points to.
struct Mesh {
  mesh::MeshPtr mesh;
  mesh::Comments notes = {};  ///< Comments that its files contain.
};

}  // namespace vug::python
