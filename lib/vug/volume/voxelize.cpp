// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/volume/crop.h>
#include <vug/volume/fitting_voxel.h>
#include <vug/volume/octree.h>
#include <vug/volume/region.h>
#include <vug/volume/trim_band.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::volume {
namespace {

/// The smallest single-precision number that OpenVDB's check accepts for `half_width` voxels.
float background_of(const VoxelizeOptions& options) {
  auto background = static_cast<float>(options.half_width * options.voxel);
  while (static_cast<double>(background) / options.voxel < options.half_width)
    background = std::nextafter(background, std::numeric_limits<float>::infinity());
  return background;
}

/// Memory if the box were filled with blocks: a bound that needs no samples.
double dense_bytes(const Box3d& box, const VoxelizeOptions& options) {
  double bytes = 2300;
  for (int axis = 0; axis < 3; ++axis)
    bytes *= (box.size()[axis] / options.voxel + 2 * options.half_width) / 8 + 2;
  return bytes;
}

/// The steps from the voxels next to a change of sign at which the band ends: one more than its
/// width, because first-order distances are also slightly too short near the surface.
int steps_of_band(const VoxelizeOptions& options) {
  return static_cast<int>(std::ceil(options.half_width)) + 1;
}

/// The tile with the blocks around it that determine where the band ends inside: the band ends
/// at steps from a voxel whose neighbour has another sign.
LatticeBox with_apron(const LatticeBox& tile, const VoxelizeOptions& options) {
  const int apron = (steps_of_band(options) + 1 + 7) / 8 * 8;
  return {tile.min - Vec3i(apron), tile.max + Vec3i(apron)};
}

void check_tile(const LatticeBox& tile) {
  for (int axis = 0; axis < 3; ++axis)
    if (tile.min[axis] % 8 != 0 || (tile.max[axis] + 1) % 8 != 0)
      throw Error(ErrorCode::bad_input,
                  fmt::format("a tile from {} to {} along an axis does not consist of whole blocks",
                              tile.min[axis], tile.max[axis]),
                  {}, "begin tiles at multiples of 8 voxels, and give them such sizes");
}

Box3d in_space(const LatticeBox& tile, double voxel) {
  return {Vec3d(tile.min) * voxel, Vec3d(tile.max) * voxel};
}

void check_memory(const field::Field& field, Box3d box, VoxelizeOptions options) {
  if (options.tile) {  // The faces that cut the solid add to the estimate.
    box = intersection(box, in_space(*options.tile, options.voxel));
    if (box.isEmpty()) return;
    options.region = box;
  }
  const uint64_t limit = options.max_memory ? options.max_memory : available_memory();
  if (dense_bytes(box, options) <= static_cast<double>(limit)) return;
  const double bytes = estimate(field, options).bytes;
  require_memory(bytes, limit, fmt::format("a level set with voxels of {} m", options.voxel),
                 fitting_voxel_hint(options.voxel, bytes, limit));
}

/// OpenVDB considers a map singular if its determinant is below 3e-15.
void check_voxel(double voxel) {
  constexpr double kSmallest = 1.5e-5;
  if (voxel >= kSmallest) return;
  throw Error(ErrorCode::bad_input,
              fmt::format("voxels of {} m are smaller than a .vdb file can represent ({} m)", voxel,
                          kSmallest),
              {}, "make the scene larger, or the voxels");
}

void find_lattice_bounds(const Box3d& box, const VoxelizeOptions& options, OctreeTask& walk) {
  constexpr double kFarthest = 2147483647.0 - 8192;
  const double margin = options.half_width + 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::floor(box.min[axis] / options.voxel - margin);
    const double high = std::ceil(box.max[axis] / options.voxel + margin);
    if (!(low >= -kFarthest && high <= kFarthest))
      throw Error(
          ErrorCode::bad_input,
          fmt::format("with voxels of {} m the solid extends beyond 2^31 voxels from the origin",
                      options.voxel),
          {}, "use a larger voxel or move the solid to the origin");
    walk.low[axis] = static_cast<int64_t>(low);
    walk.high[axis] = static_cast<int64_t>(high);
    if (!options.tile) continue;
    const LatticeBox tile = with_apron(*options.tile, options);
    walk.low[axis] = std::max<int64_t>(walk.low[axis], tile.min[axis]);
    walk.high[axis] = std::min<int64_t>(walk.high[axis], tile.max[axis]);
  }
}

LevelSet voxelize_with(const field::Field& field, const VoxelizeOptions& options, VoxelCache* cache,
                       Progress& progress) {
  const Region region = region_of(field, options);
  OctreeTask walk;
  walk.band = {options.voxel, background_of(options), options.repair};
  if (options.tile) check_tile(*options.tile);
  if (region.box.isEmpty()) return LevelSet(wrap(build(field::Field(), walk, cache, progress)));
  check_memory(field, region.box, options);
  check_voxel(options.voxel);
  find_lattice_bounds(region.box, options, walk);
  const auto grid = build(region.field, walk, cache, progress);
  if (region.field.exactness() > field::Exactness::eikonal)
    trim_band(*grid, steps_of_band(options));
  if (options.tile) crop(*grid, *options.tile);
  return LevelSet(wrap(grid));
}

}  // namespace

LevelSet voxelize(const field::Field& field, const VoxelizeOptions& options, Progress& progress) {
  return voxelize_with(field, options, nullptr, progress);
}

LevelSet voxelize(const field::Field& field, const VoxelizeOptions& options, VoxelCache& cache,
                  Progress& progress) {
  return voxelize_with(field, options, &cache, progress);
}

}  // namespace vug::volume
