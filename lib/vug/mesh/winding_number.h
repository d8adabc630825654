// SPDX-License-Identifier: Apache-2.0
// Whether a point is inside a mesh, closed or not.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// The generalized winding number (jacobson2013winding): the solid angle of all triangles as seen
/// from `p`, divided by 4 pi. It is 1 inside a closed mesh and 0 outside; with holes in the mesh it
/// is between them, and above 0.5 inside. Takes time proportional to the number of triangles.
double winding_number(const Mesh& mesh, const Vec3d& p);

}  // namespace vug::mesh
