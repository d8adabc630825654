// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the octree traversal of one brick down to the blocks that contain the
// surface. The blocks depend on the brick's expression alone, which is restricted from the whole
// field for each brick: the same brick has the same bytes in every grid that contains it. They are
// evaluated in coordinates relative to the middle of the brick, because the rounding of single
// precision grows with the coordinates: it is the same at any distance from the origin.
#pragma once

#include <vug/base/progress.h>
#include <vug/volume/tree_builder.h>
#include <vug/volume/voxel_cache.h>

#include <tbb/enumerable_thread_specific.h>

namespace vug::volume {

struct OctreeTask {
  NarrowBand band;
  int64_t low[3] = {0, 0, 0};  ///< Lattice points outside low..high are not in the band.
  int64_t high[3] = {-1, -1, -1};

  bool is_beyond(const Cell& cell) const;
};

/// Where the values of a cell are.
enum class Side { outside, inside, band };
Side side_of(const NarrowBand& band, const field::Field::RestrictedField& part);

/// Memory of one thread.
struct Workspace {
  field::Scratch scratch;
  Block block;
};
using Workspaces = tbb::enumerable_thread_specific<Workspace>;

class BrickEvaluator {
 public:
  /// `cache`: null, or keeps the blocks of the brick and has those of others.
  BrickEvaluator(const OctreeTask& walk, Workspaces& workspaces, VoxelCache* cache,
                 Progress& progress)
      : walk_(walk),
        band_(walk.band),
        workspaces_(workspaces),
        cache_(cache),
        progress_(progress) {}

  /// `field` is the whole field, restricted to the brick. `units` is the brick's share of the
  /// progress.
  void run(const field::Field& field, uint64_t units, Brick& brick);

 private:
  void visit(const field::Field& outer, const Cell& cell, uint64_t units);
  void descend(const field::Field& field, const Cell& cell, uint64_t units);
  void leaf(const field::Field& field, const Cell& cell);
  /// As `leaf`, if the cache does not have the block.
  void find_leaf(const field::Field& field, const Cell& cell);
  void done(uint64_t units);
  Cell from_middle(const Cell& cell) const;

  const OctreeTask& walk_;
  NarrowBand band_;
  Workspaces& workspaces_;
  VoxelCache* cache_;
  Progress& progress_;
  Brick* brick_ = nullptr;
  double limit_ = 0;  // Values beyond it do not matter.
};

}  // namespace vug::volume
