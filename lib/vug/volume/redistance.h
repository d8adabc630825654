// SPDX-License-Identifier: Apache-2.0
// Replaces the values of a level set's band by other distances, without moving its signs.
#pragma once

#include <vug/base/progress.h>
#include <vug/volume/level_set.h>

#include <functional>
#include <vector>

namespace vug::volume {

/// The lattice points of one block that may belong to the band.
struct BandBlock {
  std::vector<Vec3d> points;  ///< In world space, metres.
  std::vector<char> inside;   ///< Whether each point is in the solid.
};

/// Computes the unsigned distances in metres of the points of one block; points beyond the band may
/// get any larger number. Called from several threads.
using BlockDistances = std::function<void(const BandBlock& block, std::vector<double>& distances)>;

/// The level set with these distances in all voxels within its half-width of the surface; signs and
/// background stay. The lattice must be that of `voxelize`. Throws Error(cancelled).
LevelSet with_distances(const LevelSet& level_set, const BlockDistances& distances,
                        Progress& progress);

}  // namespace vug::volume
