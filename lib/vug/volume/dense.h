// SPDX-License-Identifier: Apache-2.0
// Dense copies of sparse grids.
#pragma once

#include <vug/volume/grid.h>

namespace vug::volume {

/// Copies the values of all voxels from `lower` to `upper` (inclusive) to `out`: index k varies
/// fastest, then j, then i. Voxels outside the grid's nodes have its background, or the value of
/// their tile. Throws Error(bad_input) for a grid that does not contain floats.
void copy_dense(const Grid& grid, const Vec3i& lower, const Vec3i& upper, float* out);

/// The voxel (i, j, k) lies at (i, j, k) * voxel_size() + this in world space. Metres.
Vec3d origin_of(const Grid& grid);

}  // namespace vug::volume
