// SPDX-License-Identifier: Apache-2.0
// The hint for level sets that need too much memory: a voxel size that fits.
#pragma once

#include <cstdint>
#include <string>

namespace vug::volume {

/// The smallest voxel, rounded up to two digits, with which a level set needs at most `limit`
/// bytes, if it needs `bytes` with voxels of size `voxel` (metres): its memory grows with the area
/// of the surface in voxels.
double fitting_voxel(double voxel, double bytes, double limit);

/// That voxel as a hint, e.g. "use voxels of at least 0.27 m, a smaller region", to which
/// `require_memory` adds a larger limit.
std::string fitting_voxel_hint(double voxel, double bytes, uint64_t limit);

}  // namespace vug::volume
