// SPDX-License-Identifier: Apache-2.0
// Grids of colours, numbers and identifiers that accompany a level set, with one value for each
// voxel of its band.
#pragma once

#include <vug/volume/level_set.h>

#include <string>
#include <vector>

namespace vug::volume {

/// For each active voxel of a level set, in tree order, the corresponding point of the surface.
struct BandPoints {
  std::vector<Vec3f>
      foot;  ///< Approximate nearest point of the surface, along the gradient. Metres.
  std::vector<Vec3f> normal;  ///< Unit length, out of the solid; up if there is no gradient.

  size_t size() const { return foot.size(); }
};
BandPoints band_points(const LevelSet& level_set);
/// The positions of the active voxels themselves, in tree order. Metres.
std::vector<Vec3f> band_positions(const LevelSet& level_set);

/// Creates a grid on the level set's lattice with these values in its active voxels, in the
/// order of `band_points`, and 0 elsewhere, for lookups of surface attributes in other programs.
/// Its class is fog volume, as for all grids that are neither level sets nor staggered.
Grid band_grid(const LevelSet& level_set, const std::vector<float>& values);
Grid band_grid(const LevelSet& level_set, const std::vector<Vec3f>& values);
/// Integers, such as identifiers: their class is unknown, because no program must interpolate them.
Grid band_grid(const LevelSet& level_set, const std::vector<int32_t>& values);

}  // namespace vug::volume
