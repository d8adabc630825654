// SPDX-License-Identifier: Apache-2.0
// Vertices around which a mesh cannot intersect itself.
#pragma once

#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::mesh {

/// For each vertex, whether its triangles form one closed fan whose projection along their mean
/// normal covers each direction once: no two of them intersect except in what they share.
std::vector<char> flat_fans(const Mesh& mesh);

}  // namespace vug::mesh
