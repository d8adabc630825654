// Many copies of a few meshes as one mesh: a crown of leaves that a grove can place at once.
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

/// The attribute that tells copies apart: one random number from 0 to 1 for each.
inline constexpr const char* kCopyAttribute = "copy";

/// All copies in their order, with the attributes that all meshes carry alike (others are left
/// out), and kCopy, which of a mesh that carries it already is that mesh's own. With normals where
/// all have them. The same for any number of threads. Error(too_large) beyond 2^31 vertices.
mesh::Mesh merge_instances(const std::vector<mesh::Mesh>& meshes,
                           const std::vector<MeshInstance>& copies);

}  // namespace vug::flora
