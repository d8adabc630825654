// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: trims a level set outside its band, because the first-order distances of a
// steep field are too short far from its surface.
#pragma once

#include <vug/volume/grid_access.h>

namespace vug::volume {

/// Ends the level set's band `voxels` lattice steps (each along any of the axes at once) from the
/// voxels next to a change of sign; voxels beyond get the background with their sign. No voxel
/// within that number of voxels from the surface is lost, and the surface is bit-identical.
void trim_band(openvdb::GridBase& level_set, int voxels);

}  // namespace vug::volume
