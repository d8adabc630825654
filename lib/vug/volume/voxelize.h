// SPDX-License-Identifier: Apache-2.0
// Conversion of a field expression to a sparse level set. Blocks that the surface cannot touch are
// skipped by means of the expression's bounds, and every remaining block is evaluated with only the
// operands that can matter in it (after barbier2025, keeter2020).
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/volume/level_set.h>
#include <vug/volume/voxel_cache.h>

#include <Imath/ImathBox.h>

#include <optional>

namespace vug::volume {

/// Lattice points from `min` to `max`, which are included.
using LatticeBox = Imath::Box3i;

struct VoxelizeOptions {
  double voxel = 0.1;  ///< Edge of a voxel, metres.
  double half_width =
      3;               ///< Half-width of the band in voxels; at least 3, as OpenVDB's tools expect.
  bool repair = true;  ///< Divide values that are not distances by the length of their gradient.
  std::optional<Box3d> region;  ///< Region to voxelize; solids are cut off by its faces. Default:
                                ///< the field's bounds, which must then be finite.
  std::optional<LatticeBox> tile;  ///< The part of the lattice to compute; solids continue beyond
                                   ///< it. Whole blocks: `min` and `max` + 1 are multiples of 8.
  uint64_t max_memory = 0;  ///< Memory limit in bytes; 0: the available memory of the machine.
};

/// Estimated costs, from samples of the field; no grid is created.
struct VoxelizeEstimate {
  double surface_area = 0;  ///< Square metres.
  double active_voxels = 0;
  double leaves = 0;
  double bytes = 0;  ///< Peak memory: the finished grid and the working set.
};
VoxelizeEstimate estimate(const field::Field& field, const VoxelizeOptions& options);

/// The field that `voxelize` samples: the given one, cut off by the faces of the region. Throws
/// Error(bad_input) as `voxelize` does.
field::Field field_in_region(const field::Field& field, const VoxelizeOptions& options);

/// The zero set of the level set equals that of the field up to trilinear interpolation; the repair
/// does not move it. Values are exact distances where the field's are; elsewhere the band ends four
/// lattice steps from the surface (see trim_band.h). The result has the same bytes for any
/// number of threads, and a voxel has the same value in every tile that contains it (bricks.h). An
/// empty field gives an empty grid. Throws Error(bad_input) for bounds that
/// are not finite, options out of range, or lattice points beyond 32-bit indices; Error(too_large)
/// before the work starts; Error(cancelled).
LevelSet voxelize(const field::Field& field, const VoxelizeOptions& options,
                  Progress& progress = Progress::none());

/// The same bytes; parts on which the field is as in an earlier call with this cache are not
/// evaluated again. See voxel_cache.h.
LevelSet voxelize(const field::Field& field, const VoxelizeOptions& options, VoxelCache& cache,
                  Progress& progress = Progress::none());

}  // namespace vug::volume
