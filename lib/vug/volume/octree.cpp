// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/octree.h>

namespace vug::volume {
namespace {

int64_t aligned(int64_t index, int64_t to) { return index & ~(to - 1); }  // Towards -infinity.

class OctreeBuilder {
 public:
  OctreeBuilder(const field::Field& field, const OctreeTask& walk, VoxelCache* cache,
                Progress& progress)
      : field_(field),
        walk_(walk),
        limit_(std::max(static_cast<double>(walk.band.background), reach(walk.band, field))),
        tree_(walk.band.voxel, walk.band.background),
        cache_(cache),
        progress_(progress) {}

  std::shared_ptr<openvdb::GridBase> run() {
    progress_.begin("voxels", kUnits);
    visit(field_, root_around(walk_), kUnits);
    progress_.end();
    return tree_.finish();
  }

 private:
  static constexpr uint64_t kUnits = uint64_t{1}
                                     << 30;  // Progress units, distributed in proportion to space.

  /// Above the size of bricks, cells serve to skip space. A brick begins again with the whole
  /// field, so that its voxels do not depend on the cells around it.
  void visit(const field::Field& outer, const Cell& cell, uint64_t units) {
    progress_.check();
    if (walk_.is_beyond(cell)) return progress_.advance(units);
    const bool is_brick = cell.size == Brick::kSize;
    const field::Field::RestrictedField part =
        (is_brick ? field_ : outer).restricted_near(ball_around(cell, walk_.band.voxel), limit_);
    switch (side_of(walk_.band, part)) {
      case Side::outside:
        return progress_.advance(units);
      case Side::inside:
        tree_.fill_inside(cell);
        return progress_.advance(units);
      case Side::band:
        break;
    }
    if (is_brick) {
      Brick brick(cell);
      BrickEvaluator(walk_, workspaces_, cache_, progress_).run(part.field, units, brick);
      return tree_.add(brick);
    }
    parallel_for(8,
                 [&](size_t n) { visit(part.field, cell.child(static_cast<int>(n)), units / 8); });
  }

  const field::Field& field_;
  OctreeTask walk_;
  double limit_;  // Values beyond it do not matter.
  TreeBuilder tree_;
  VoxelCache* cache_;
  Progress& progress_;
  Workspaces workspaces_;
};

}  // namespace

Cell root_around(const OctreeTask& walk) {
  Cell root;
  for (root.size = Brick::kSize;; root.size *= 2) {
    bool fits = true;
    for (int axis = 0; axis < 3; ++axis) {
      root.origin[axis] = aligned(walk.low[axis], std::min<int64_t>(root.size, 4096));
      fits = fits && root.origin[axis] + root.size > walk.high[axis];
    }
    if (fits) return root;
  }
}

std::shared_ptr<openvdb::GridBase> build(const field::Field& field, const OctreeTask& walk,
                                         VoxelCache* cache, Progress& progress) {
  return OctreeBuilder(field, walk, cache, progress).run();
}

}  // namespace vug::volume
