// SPDX-License-Identifier: Apache-2.0
// Narrow-band level sets: signed distances in metres, negative inside, stored near the surface.
#pragma once

#include <vug/volume/grid.h>

#include <vector>

namespace vug::volume {

/// A float grid with level-set values: active voxels have |value| < background, inactive ones
/// exactly -background (inside) or background (outside). With `voxelize`, lattice point (i, j, k)
/// lies at (i, j, k) * voxel in world space.
class LevelSet : public Grid {
 public:
  /// Throws Error(bad_input) unless the grid is a level set of floats with cubic voxels.
  explicit LevelSet(const Grid& grid);

  double voxel() const;       ///< Edge of a voxel, metres.
  double background() const;  ///< Half-width of the band, metres.
  bool empty() const;         ///< True if no voxel is active.
  bool holds_solid() const;   ///< True if some voxel lies inside by more than rounding.

  /// Trilinear interpolation in world space; +-background outside the band.
  double value(const Vec3d& p) const;
  /// Values at many points, computed in parallel.
  std::vector<double> values(const std::vector<Vec3d>& points) const;
};

/// The result of OpenVDB's checkLevelSet: tests 1-8 (type, class, transform, band, tiles, finite,
/// range, inactive values) must pass for all files written by this project.
struct LevelSetReport {
  std::string fault;  ///< Empty if tests 1-8 pass.
  double share_off_unit_slope =
      0;  ///< Test 9 as a statistic: the fraction of active voxels whose gradient length is not in
          ///< 0.5..1.5, as is normal at creases.
  bool good() const { return fault.empty(); }
};
LevelSetReport check(const LevelSet& level_set);

}  // namespace vug::volume
