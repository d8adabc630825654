// From a field expression straight to a sparse level set: blocks that the surface cannot touch
// are left out by the expression's own bounds, and every block that is kept is evaluated with
// only those operands that can matter in it (after barbier2025, keeter2020).
#pragma once

#include <vug/base/progress.h>
#include <vug/field/field.h>
#include <vug/volume/level_set.h>

#include <optional>

namespace vug::volume {

struct VoxelizeOptions {
  double voxel = 0.1;     ///< Edge of a voxel, metres.
  double half_width = 3;  ///< Half the band, in voxels; 3 at least, as OpenVDB's tools expect.
  bool repair = true;     ///< Divide values that are no distances by their gradient's length.
  std::optional<Box3d> region;  ///< Solid outside is cut off by flat faces. Default: the field's
                                ///< bounds, which must then be finite.
  uint64_t max_memory = 0;  ///< Bytes that the work may take; 0: what the machine has available.
};

/// What the work will take, from samples of the field; no grid is made.
struct VoxelizeEstimate {
  double surface_area = 0;  ///< Square metres.
  double active_voxels = 0;
  double leaves = 0;
  double bytes = 0;  ///< Peak: the finished grid and the working set.
};
VoxelizeEstimate estimate(const field::Field& field, const VoxelizeOptions& options);

/// The zero set of the field is that of the level set up to trilinear interpolation: repairing
/// does not move it. Values are exact distances where the field's are; where they are not, the band
/// ends four lattice steps from the surface (see trim.h). The same bytes for any number of threads.
/// An empty field gives an empty grid. Error(bad_input) for bounds that are not finite, options out
/// of range, or lattice points beyond 32-bit indices; Error(too_large) before the work starts;
/// Error(cancelled).
LevelSet voxelize(const field::Field& field, const VoxelizeOptions& options,
                  Progress& progress = Progress::none());

}  // namespace vug::volume
