// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/volume/fog.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>

#include <openvdb/tools/LevelSetUtil.h>

namespace vug::volume {

Grid fog(const LevelSet& level_set, const FogOptions& options) {
  if (!(options.falloff >= 0))
    throw Error(ErrorCode::bad_input, "a fog's falloff must not be negative");
  const auto& source = static_cast<const openvdb::FloatGrid&>(*level_set.data().grid);
  const openvdb::FloatGrid::Ptr out = source.deepCopy();
  const float band = source.background();
  const auto falloff = static_cast<float>(options.falloff);
  openvdb::tools::sdfToFogVolume(*out, falloff > 0 && falloff < band ? falloff : band);
  return wrap(out);
}

}  // namespace vug::volume
