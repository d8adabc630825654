// SPDX-License-Identifier: Apache-2.0
// Triangle meshes of the polygons that a turtle draws.
#pragma once

#include <vug/lsystem/drawing.h>
#include <vug/mesh/mesh.h>

namespace vug::flora {

/// Triangulates each polygon, including non-convex ones, and adds the attributes "order" and
/// "colour". The shading is smooth where polygons share corners. Expects nearly flat polygons
/// without self-intersections; for others some triangles may lie outside.
mesh::Mesh polygon_mesh(const lsystem::Drawing& drawing);

}  // namespace vug::flora
