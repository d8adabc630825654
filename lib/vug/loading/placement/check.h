// SPDX-License-Identifier: Apache-2.0
// Finds mistakes of set dressing before a picture is rendered: cameras and lights in rock, props in
// mid-air, voids that another part of the rock fills, and passages that leave the terrain.
#pragma once

#include <vug/loading/load.h>
#include <vug/loading/placement/solid.h>

namespace vug::loading {

struct PlacementOptions {
  std::string camera;  ///< The only camera to check; empty: all of them.
  Accuracy accuracy = Accuracy::bounds;
  const shot::Shot* part = nullptr;  ///< The part of the shot to check; null: all of it.
};

/// Adds an error for each mistake of a scene without errors, at the declaration of the camera, the
/// light, the object or the `place`, or at the void. A camera may be inside a body of water or
/// glass, an orthographic camera also in rock, since it shows sections; a camera within half a
/// voxel of the surface is a warning. A light may be inside any body that light can leave, and is
/// only reported if it is in rock with all of its shape. A level set of the scene itself in mid-air
/// is a warning, since it may have been modelled there. With Accuracy::bounds, speleothems of
/// `dripstone` are taken into account for props only.
void check_placement(const Loaded& scene, const PlacementOptions& options,
                     Diagnostics& diagnostics);

}  // namespace vug::loading
