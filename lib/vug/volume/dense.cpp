// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/volume/dense.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>

#include <fmt/format.h>
#include <openvdb/tools/Dense.h>

namespace vug::volume {

void copy_dense(const Grid& grid, const Vec3i& lower, const Vec3i& upper, float* out) {
  const openvdb::GridBase& base = *grid.data().grid;
  if (!base.isType<openvdb::FloatGrid>())
    throw Error(ErrorCode::bad_input,
                fmt::format("grid '{}' does not contain floats, its values are {}", grid.name(),
                            grid.value_type()));
  const openvdb::CoordBBox box({lower.x, lower.y, lower.z}, {upper.x, upper.y, upper.z});
  if (box.empty()) return;
  openvdb::tools::Dense<float, openvdb::tools::LayoutZYX> dense(box, out);
  openvdb::tools::copyToDense(static_cast<const openvdb::FloatGrid&>(base), dense);
}

Vec3d origin_of(const Grid& grid) {
  const openvdb::Vec3d origin = grid.data().grid->indexToWorld(openvdb::Vec3d(0.0));
  return {origin.x(), origin.y(), origin.z()};
}

}  // namespace vug::volume
