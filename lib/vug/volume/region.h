// Inside volume/ only: which part of a field is voxelized.
#pragma once

#include <vug/volume/voxelize.h>

namespace vug::volume {

struct Region {
  field::Field field;  ///< Cut off at the region's faces where the solid crosses them.
  Box3d box;           ///< Holds the solid; finite, or empty.
};

/// Checks the options too. Error(bad_input).
Region region_of(const field::Field& field, const VoxelizeOptions& options);

}  // namespace vug::volume
