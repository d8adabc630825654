// SPDX-License-Identifier: Apache-2.0
// Swept stems as meshes: closed, 2-manifold, oriented outwards, one component for each stem and
// each closed chamber, with vertices on the surface of sweep_field.h. Stems intersect their
// parents. Every vertex carries attributes about its position on the plant for materials; see
// stem_attributes().
#pragma once

#include <vug/flora/tube.h>
#include <vug/mesh/mesh.h>

namespace vug::flora {

struct MeshOptions {
  /// Maximum distance in metres by which a straight edge around a stem cuts into it.
  double tolerance = 0.2e-3;
  int min_sides = 5;
  int max_sides = 128;
};

struct AttributeInfo {
  const char* name;
  const char* doc;
};
/// Vertex attributes ("along", "height", ...) and their descriptions.
const std::vector<AttributeInfo>& stem_attributes();

/// The surfaces of the tubes with unit normals; the same bytes for any number of threads.
/// Error(too_large) beyond 2^32 - 1 vertices.
mesh::Mesh swept_mesh(const std::vector<Tube>& tubes, const MeshOptions& options = {});

}  // namespace vug::flora
