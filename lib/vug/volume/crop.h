// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the part of a level set in a box of its lattice.
#pragma once

#include <vug/volume/grid_access.h>
#include <vug/volume/voxelize.h>

namespace vug::volume {

/// Replaces the voxels of a level set outside of the box by its background. The box consists of
/// whole blocks.
void crop(openvdb::GridBase& level_set, const LatticeBox& box);

}  // namespace vug::volume
