// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/octree.h>
#include <vug/volume/tree_builder.h>

#include <tbb/enumerable_thread_specific.h>

namespace vug::volume {
namespace {

int64_t aligned(int64_t index, int64_t to) { return index & ~(to - 1); }  // Towards -infinity.

class OctreeBuilder {
 public:
  OctreeBuilder(const OctreeTask& walk, Progress& progress)
      : walk_(walk), tree_(walk.band.voxel, walk.band.background), progress_(progress) {}

  std::shared_ptr<openvdb::GridBase> run(const field::Field& field) {
    const Cell root = root_around(walk_);
    limit_ = std::max(static_cast<double>(walk_.band.background), reach(walk_.band, field));
    progress_.begin("voxels", kUnits);
    visit(field, root, nullptr, kUnits);
    progress_.end();
    return tree_.finish();
  }

 private:
  enum class Verdict { outside, inside, band };
  static constexpr uint64_t kUnits = uint64_t{1}
                                     << 30;  // Progress units, distributed in proportion to space.

  Verdict judge(const field::Field& field, Interval range) const {
    const double limit = reach(walk_.band, field);
    if (range.lo > limit) return Verdict::outside;
    if (range.hi < -limit) return Verdict::inside;
    return Verdict::band;
  }

  bool beyond_bounds(const Cell& cell) const {
    for (int axis = 0; axis < 3; ++axis)
      if (cell.origin[axis] > walk_.high[axis] ||
          cell.origin[axis] + cell.size - 1 < walk_.low[axis])
        return true;
    return false;
  }

  /// `brick` is the 128^3 node that contains the cell, or null above that size.
  void visit(const field::Field& outer, const Cell& cell, Brick* brick, uint64_t units) {
    if (cell.size > kBlock) progress_.check();
    if (beyond_bounds(cell)) return done(units);
    // Nodes that are evaluated near their surface choose operands for each block themselves.
    if (brick && cell.size == kBlock && near_surface_of(outer, walk_.band)) {
      leaf(outer, cell, *brick);
      return done(units);
    }
    const field::Field::RestrictedField part =
        outer.restricted_near(ball_around(cell, walk_.band.voxel), limit_);
    switch (judge(part.field, part.range)) {
      case Verdict::outside:
        return done(units);
      case Verdict::inside:
        brick ? brick->fill_inside(cell) : tree_.fill_inside(cell);
        return done(units);
      case Verdict::band:
        break;
    }
    if (cell.size == kBlock) {
      leaf(part.field, cell, *brick);
    } else if (cell.size == Brick::kSize && !brick) {
      Brick own(cell);
      descend(part.field, cell, &own, units);
      tree_.add(own);
      return;
    } else {
      return descend(part.field, cell, brick, units);
    }
    done(units);
  }

  void done(uint64_t units) {
    if (units) progress_.advance(units);
  }

  void descend(const field::Field& field, const Cell& cell, Brick* brick, uint64_t units) {
    const auto child = [&](size_t n) {
      visit(field, cell.child(static_cast<int>(n)), brick, cell.size > kSerial ? units / 8 : 0);
    };
    if (cell.size > kSerial) return parallel_for(8, child);
    for (size_t n = 0; n < 8; ++n) child(n);
    done(units);
  }

  void leaf(const field::Field& field, const Cell& cell, Brick& brick) {
    Local& local = locals_.local();
    evaluate(field, cell, walk_.band, local.scratch, local.block);
    if (local.block.any_active())
      brick.set(cell, local.block);
    else if (local.block.values[0] < 0)
      brick.fill_inside(cell);
  }

  struct Local {
    field::Scratch scratch;
    Block block;
  };
  static constexpr int64_t kBlock = 8;
  static constexpr int64_t kSerial = 32;  // Cells of at most this size are one task.

  OctreeTask walk_;
  double limit_ = 0;  // Values beyond it do not matter.
  TreeBuilder tree_;
  Progress& progress_;
  tbb::enumerable_thread_specific<Local> locals_;
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
                                         Progress& progress) {
  return OctreeBuilder(walk, progress).run(field);
}

}  // namespace vug::volume
