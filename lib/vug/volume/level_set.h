// Narrow-band level sets: signed distances in metres, negative inside, kept near the surface.
#pragma once

#include <vug/volume/grid.h>

#include <vector>

namespace vug::volume {

/// A Grid of floats that is a level set: active voxels hold |value| < background, inactive ones
/// exactly -background (inside) or background (outside). Lattice point (i, j, k) lies at
/// (i, j, k) * voxel in world space when made by `voxelize`.
class LevelSet : public Grid {
 public:
  /// Error(bad_input) when the grid is no level set of floats with cubic voxels.
  explicit LevelSet(const Grid& grid);

  double voxel() const;       ///< Edge of a voxel, metres.
  double background() const;  ///< Half the width of the band, metres.
  bool empty() const;         ///< No voxel is active.
  bool holds_solid() const;   ///< Some voxel lies inside by more than rounding.

  /// Trilinear interpolation at a point of world space; +-background away from the band.
  double value(const Vec3d& p) const;
  /// Values at many points; parallel.
  std::vector<double> values(const std::vector<Vec3d>& points) const;
};

/// What checkLevelSet of OpenVDB says: tests 1-8 (type, class, transform, band, tiles, finite,
/// range, inactive values) must pass for any file this project writes.
struct LevelSetReport {
  std::string fault;                ///< Empty when tests 1-8 pass.
  double share_off_unit_slope = 0;  ///< Test 9 as a statistic: active voxels whose gradient's
                                    ///< length is not in 0.5..1.5, as happens at honest creases.
  bool good() const { return fault.empty(); }
};
LevelSetReport check(const LevelSet& level_set);

}  // namespace vug::volume
