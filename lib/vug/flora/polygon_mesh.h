// The polygons that a turtle draws, as sheets of triangles.
#pragma once

#include <vug/lsystem/drawing.h>
#include <vug/mesh/mesh.h>

namespace vug::flora {

/// Each polygon cut into triangles (also where its outline is not convex), with the attributes
/// "order" and "colour". Sheets are smooth where corners of several lie in one place. Nearly flat
/// polygons without crossings are meant; of others some triangles may lie outside.
mesh::Mesh polygon_mesh(const lsystem::Drawing& drawing);

}  // namespace vug::flora
