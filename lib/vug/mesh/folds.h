// SPDX-License-Identifier: Apache-2.0
// Detects folded triangles: those that face against the surface around them.
#pragma once

#include <vug/mesh/fans.h>

namespace vug::mesh {

/// The triangles whose normal differs by more than 120 degrees from the normals at all three
/// corners (see vertex_normals), ascending. The sides of thin blades and of tips are not: each of
/// them contributes to these normals.
std::vector<uint32_t> folded_triangles(const Mesh& mesh);

/// Whether one triangle is folded in that sense.
bool is_folded(const Mesh& mesh, const Fans& fans, uint32_t face);

}  // namespace vug::mesh
