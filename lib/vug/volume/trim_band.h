// What a level set holds beyond its band, because a steep field's first-order distances are too
// short far from its surface.
#pragma once

#include <vug/volume/grid_access.h>

namespace vug::volume {

/// Ends a level set's band `voxels` lattice steps (each along any of the axes at once) from the
/// voxels beside a change of sign; what lies beyond gets the background, with its sign. No voxel
/// whose distance to the surface is at most that many voxels is lost, and the surface stays to
/// the bit.
void trim_band(openvdb::GridBase& level_set, int voxels);

}  // namespace vug::volume
