// SPDX-License-Identifier: Apache-2.0
// For any bytes, the reader returns a cloud of finite points with lists of matching lengths, or
// fails.
#include "require.h"
#include "target.h"

#include <vug/base/error.h>
#include <vug/scan/read.h>

#include <cmath>
#include <cstdint>

VUG_FUZZ_TARGET(cloud) {
  using vug::require;
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const vug::scan::PointCloud cloud = vug::scan::parse_cloud(bytes, "fuzz", {.memory = 1 << 28});
    require(cloud.size() > 0, "a cloud has points");
    for (const vug::Vec3d& p : cloud.positions)
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "they are finite");
    for (const size_t items :
         {cloud.colours.size(), cloud.intensities.size(), cloud.normals.size()})
      require(items == 0 || items == cloud.size(), "lists are empty or have one item a point");
  } catch (const vug::Error& error) {
    require(error.code() == vug::ErrorCode::bad_input || error.code() == vug::ErrorCode::too_large,
            "bytes are bad or too many");
    require(error.where().file == "fuzz" || error.code() == vug::ErrorCode::too_large,
            "faults name the file");
  }
}
