// SPDX-License-Identifier: Apache-2.0
// Merges the copies inside a scene into single meshes, so that a grove can instance the scene
// efficiently.
#pragma once

#include <vug/render/scene.h>

#include <vector>

namespace vug::building {

/// Replaces the instances of one mesh that share name and material by one object with the combined
/// mesh. The material is evaluated in the space of the scene, and the attribute "copy" numbers the
/// copies. Objects that move, are emissive, have a world-space material, or have a level set for
/// masks are kept. The order is that of first appearance. Error(too_large).
std::vector<render::Object> merge_copies(const std::vector<render::Object>& objects);

}  // namespace vug::building
