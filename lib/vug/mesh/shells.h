// SPDX-License-Identifier: Apache-2.0
// The closed surfaces of a mesh and the volumes that they enclose.
#pragma once

#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::mesh {

/// A component of a mesh: triangles that are connected by edges.
struct Shell {
  Mesh surface;       ///< Without attributes.
  double volume = 0;  ///< Cubic metres; negative if the normals point into the enclosed space.
};

/// The components of a closed mesh, those with the largest absolute volumes first; equal ones are
/// in the order of their first triangles.
std::vector<Shell> shells(const Mesh& closed);

}  // namespace vug::mesh
