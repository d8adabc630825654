// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the voxels around the zero set of a level set.
#pragma once

#include <openvdb/openvdb.h>

namespace vug::volume {

/// The voxels next to a change of sign; the mask has the leaves of the level set.
openvdb::MaskTree surface_marks(const openvdb::FloatTree& level_set);

/// The voxels next to a change of sign, and those within `voxels` lattice steps (along axes and
/// diagonals) of one.
openvdb::MaskTree surface_mask(const openvdb::FloatTree& level_set, int voxels);

}  // namespace vug::volume
