// SPDX-License-Identifier: Apache-2.0
// Folded triangles: those that face against the surface around them.
#pragma once

#include <vug/mesh/fans.h>

namespace vug::mesh {

/// The triangles whose normal is opposed to the sum of the normals at their corners (see
/// vertex_normals), ascending. The sides of a sharp tip or edge are not: each of them contributes
/// to these normals.
std::vector<uint32_t> folded_triangles(const Mesh& mesh);

/// Whether one triangle is folded in that sense.
bool is_folded(const Mesh& mesh, const Fans& fans, uint32_t face);

}  // namespace vug::mesh
