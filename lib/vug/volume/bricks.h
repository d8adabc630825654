// SPDX-License-Identifier: Apache-2.0
// Tiles of level sets, which voxelize computes one at a time, and their comparison by bricks: the
// cubes of 128^3 voxels of the absolute lattice.
#pragma once

#include <vug/volume/level_set.h>
#include <vug/volume/voxelize.h>

#include <array>
#include <map>
#include <vector>

namespace vug::volume {

constexpr int kBrickEdge = 128;

/// The lattice point of a brick with the smallest coordinates; they are multiples of kBrickEdge.
using BrickOrigin = std::array<int, 3>;

/// The digests of all bricks but those whose voxels are all outside, beyond the band. A digest
/// covers the values and the activity of all voxels, and neither the position of the brick nor the
/// way in which the tree stores it.
std::map<BrickOrigin, Digest> brick_digests(const LevelSet& level_set);

/// The level set that consists of tiles of one lattice, which have no voxel in common. Throws
/// Error(bad_input) if there are none, or if their voxels or bands differ.
LevelSet joined(const std::vector<LevelSet>& tiles);

/// The part in a box of whole blocks; voxels outside of it are outside of the solid.
LevelSet cropped(const LevelSet& level_set, const LatticeBox& box);

}  // namespace vug::volume
