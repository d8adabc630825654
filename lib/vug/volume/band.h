// Grids of colours and numbers beside a level set: one value for each voxel of its band.
#pragma once

#include <vug/volume/level_set.h>

#include <string>
#include <vector>

namespace vug::volume {

/// For each active voxel of a level set, in the tree's order, the place on the surface that it
/// belongs to.
struct BandPoints {
  std::vector<Vec3f> foot;    ///< About the nearest on the surface: along the gradient. Metres.
  std::vector<Vec3f> normal;  ///< Unit length, out of the solid; up where there is no gradient.

  size_t size() const { return foot.size(); }
};
BandPoints band_points(const LevelSet& level_set);

/// A grid of the level set's lattice with these values in its active voxels, in the order of
/// `band`, and 0 elsewhere: programs look up in it what is on the surface. Its class is fog
/// volume, as that of all that is neither a level set nor staggered.
Grid band_grid(const LevelSet& level_set, const std::vector<float>& values);
Grid band_grid(const LevelSet& level_set, const std::vector<Vec3f>& values);

}  // namespace vug::volume
