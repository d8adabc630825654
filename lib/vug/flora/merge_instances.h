// SPDX-License-Identifier: Apache-2.0
// Merges many instances of a few meshes into one mesh, such as a crown of leaves that a grove
// instances as a whole.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/transform.h>
#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::flora {

struct MeshInstance {
  size_t mesh = 0;  ///< Index into the meshes.
  Transform to;
  RandomKey key{0};
};

/// Attribute that distinguishes instances: a random number from 0 to 1 per instance.
inline constexpr const char* kCopyAttribute = "copy";

/// All instances in order. The result has the attributes common to all meshes (others are dropped)
/// and kCopyAttribute; a mesh that already has it keeps its own values. It has normals if all
/// meshes have them. The result does not depend on the number of threads. Error(too_large) beyond
/// 2^31 vertices.
mesh::Mesh merge_instances(const std::vector<mesh::Mesh>& meshes,
                           const std::vector<MeshInstance>& copies);

}  // namespace vug::flora
