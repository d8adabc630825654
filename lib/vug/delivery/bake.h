// SPDX-License-Identifier: Apache-2.0
// Bakes the material of an object to vertex attributes of its mesh.
#pragma once

#include <vug/exchange/look.h>
#include <vug/render/scene.h>

#include <vector>

namespace vug::delivery {

struct BakeResult {
  /// The mesh with an attribute for each channel of the look that varies; without normals for a
  /// flat object.
  mesh::MeshPtr mesh;
  exchange::Look look;  ///< Mean values of all channels.
  /// The mean looks of the rocks that have triangles; see exchange::Prototype.
  std::vector<exchange::RockLook> rocks = {};
};

/// Bakes the object's material, viewed from outside, in the mesh's own space or, for world-space
/// materials, at the position of the instance. "Cd" receives the base colour. Meshes with holes are
/// cut (see cutout_mesh.h). An attribute of the mesh with the name of a channel is kept as
/// "raw_NAME".
BakeResult bake(const render::Object& object);

}  // namespace vug::delivery
