// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the octree traversal from a cube of the lattice down to the bricks that
// contain the surface.
#pragma once

#include <vug/base/progress.h>
#include <vug/volume/brick_evaluator.h>
#include <vug/volume/grid_access.h>

namespace vug::volume {

/// The root cube around low..high: its size is a power of two, at least 128, and it is aligned to
/// min(size, 4096), so that its children are nodes of the tree.
Cell root_around(const OctreeTask& walk);

/// Builds the level set's grid without name and metadata; the same for any number of threads.
/// `cache` may be null.
std::shared_ptr<openvdb::GridBase> build(const field::Field& field, const OctreeTask& walk,
                                         VoxelCache* cache, Progress& progress);

}  // namespace vug::volume
