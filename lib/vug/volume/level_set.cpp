// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/contact.h>
#include <vug/volume/level_set.h>
#include <vug/volume/openvdb_values.h>

#include <fmt/format.h>
#include <openvdb/tools/Diagnostics.h>
#include <openvdb/tools/Interpolation.h>

#include <algorithm>

namespace vug::volume {
LevelSet::LevelSet(const Grid& grid) : Grid(grid) {
  const openvdb::GridBase& base = *grid.data().grid;
  if (!base.isType<openvdb::FloatGrid>() || base.getGridClass() != openvdb::GRID_LEVEL_SET)
    throw Error(ErrorCode::bad_input,
                fmt::format("grid '{}' is not a level set: its class is {}, its values are {}",
                            grid.name(), to_string(grid.grid_class()), grid.value_type()));
  if (!base.hasUniformVoxels() || !(background() > 0))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the voxels of level set '{}' are not cubes, or it has no band", grid.name()));
}

double LevelSet::voxel() const { return data().grid->voxelSize().x(); }
double LevelSet::background() const { return static_cast<double>(floats(*this).background()); }
bool LevelSet::empty() const {
  return !floats(*this).tree().hasActiveTiles() && floats(*this).activeVoxelCount() == 0;
}

bool LevelSet::holds_solid() const {
  const auto inside = static_cast<float>(-kContactInVoxels * voxel());
  for (auto leaf = floats(*this).tree().cbeginLeaf(); leaf; ++leaf)
    for (auto value = leaf->cbeginValueOn(); value; ++value)
      if (*value < inside) return true;
  return false;
}

double LevelSet::value(const Vec3d& p) const { return values({p})[0]; }

std::vector<double> LevelSet::values(const std::vector<Vec3d>& points) const {
  const openvdb::FloatGrid& grid = floats(*this);
  std::vector<double> out(points.size());
  constexpr size_t kChunk = 1024;  // For one accessor.
  parallel_for((points.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    const auto accessor = grid.getConstAccessor();
    const size_t end = std::min(points.size(), (chunk + 1) * kChunk);
    for (size_t i = chunk * kChunk; i < end; ++i) {
      const openvdb::Vec3d index =
          grid.worldToIndex(openvdb::Vec3d(points[i].x, points[i].y, points[i].z));
      out[i] = static_cast<double>(openvdb::tools::BoxSampler::sample(accessor, index));
    }
  });
  return out;
}

LevelSetReport check(const LevelSet& level_set) {
  openvdb::tools::CheckLevelSet<openvdb::FloatGrid> checks(floats(level_set));
  LevelSetReport report;
  report.fault = checks.check(8, false);
  if (!report.good() || level_set.empty()) return report;
  checks.checkEikonal(true);
  report.share_off_unit_slope = static_cast<double>(checks.failureCount()) /
                                static_cast<double>(floats(level_set).activeVoxelCount());
  return report;
}

}  // namespace vug::volume
