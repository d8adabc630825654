// Voxels of a sparse grid as a dense block.
#pragma once

#include <vug/volume/grid.h>

namespace vug::volume {

/// Writes the values of all voxels from `lower` to `upper`, both included, to `out`: the index k
/// runs fastest, then j, then i. Voxels that the grid does not hold have its background, or the
/// value of the tile they lie in. Error(bad_input) for a grid that is not of floats.
void copy_dense(const Grid& grid, const Vec3i& lower, const Vec3i& upper, float* out);

/// The point in world space of the voxel (i, j, k) is (i, j, k) * voxel_size() + this. Metres.
Vec3d origin_of(const Grid& grid);

}  // namespace vug::volume
