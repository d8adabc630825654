// Swept stems as meshes: closed, 2-manifold, outward, one piece for each stem and for each closed
// chamber, whose vertices lie on the surface of sweep_field.h. Stems pass into their parents.
//
// Every vertex carries what a material needs to know of where it is on the plant: see kAttributes.
#pragma once

#include <vug/flora/tube.h>
#include <vug/mesh/mesh.h>

namespace vug::flora {

struct MeshOptions {
  double tolerance = 0.2e-3;  ///< Metres that a straight edge around a stem may cut into it.
  int min_sides = 5;
  int max_sides = 128;
};

struct AttributeInfo {
  const char* name;
  const char* doc;
};
/// "along", "height", ...: the numbers at each vertex, with what they are.
const std::vector<AttributeInfo>& stem_attributes();

/// The tubes' surfaces with unit normals; the same bytes for any number of threads.
/// Error(too_large) where there would be more than 2^32 - 1 vertices.
mesh::Mesh swept_mesh(const std::vector<Tube>& tubes, const MeshOptions& options = {});

}  // namespace vug::flora
