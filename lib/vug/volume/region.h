// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the region of a field that is voxelized.
#pragma once

#include <vug/volume/voxelize.h>

namespace vug::volume {

struct Region {
  field::Field field;  ///< Cut off at the region's faces if the solid crosses them.
  Box3d box;           ///< Contains the solid; finite or empty.
};

/// Also validates the options. Throws Error(bad_input).
Region region_of(const field::Field& field, const VoxelizeOptions& options);

}  // namespace vug::volume
