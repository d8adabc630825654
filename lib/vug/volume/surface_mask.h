// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the voxels around the zero set of a level set.
#pragma once

#include <openvdb/openvdb.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::volume {

/// One bit for each voxel of a leaf: a word for each x, bit 8 y + z. The order of OpenVDB's masks.
using LeafBits = std::array<uint64_t, 8>;

/// One word of a leaf's active voxels.
inline uint64_t active_bits(const openvdb::FloatTree::LeafNodeType& leaf, size_t x) {
  return leaf.getValueMask().getWord<uint64_t>(static_cast<openvdb::Index>(x));
}

/// The active voxels next to a change of sign, for each leaf of the level set. The transient data
/// of a leaf is its index.
struct SurfaceMarks {
  std::vector<openvdb::FloatTree::LeafNodeType*> leaves;
  std::vector<LeafBits> bits;
};
SurfaceMarks surface_marks(openvdb::FloatTree& level_set);

/// The active voxels next to a change of sign, and those within `voxels` lattice steps (along axes
/// and diagonals) of one.
openvdb::MaskTree surface_mask(openvdb::FloatTree& level_set, int voxels);

}  // namespace vug::volume
