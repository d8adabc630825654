// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/openvdb_values.h>
#include <vug/volume/wider_band.h>

#include <openvdb/tools/FastSweeping.h>

#include <cmath>

namespace vug::volume {

LevelSet with_half_width(const LevelSet& level_set, double half_width) {
  const double missing = half_width - level_set.background();
  if (!(missing > 0)) return level_set;
  initialise_openvdb();
  const int layers = static_cast<int>(std::ceil(missing / level_set.voxel())) + 1;
  const openvdb::FloatGrid::Ptr wider = openvdb::tools::dilateSdf(floats(level_set), layers);
  return LevelSet(wrap(wider));
}

}  // namespace vug::volume
