// SPDX-License-Identifier: Apache-2.0
// The surface is found and dilated with one bit for each voxel, because a lookup of each neighbour
// takes longer than the evaluation of most fields.
#include <vug/base/parallel.h>
#include <vug/volume/surface_mask.h>
#include <vug/volume/trim_band.h>

#include <openvdb/tools/Prune.h>

#include <type_traits>
#include <vector>

namespace vug::volume {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;

/// The most steps for which the leaves around a leaf suffice.
constexpr int kMostSteps = 8;

/// Marks within `kReach` lattice steps of a leaf's voxels, gathered from it and its 26 neighbours.
template <int kReach>
class Neighbourhood {
 public:
  void add(const LeafBits& bits, int x, int y, int z) {
    for (int i = first(x); i < last(x); ++i)
      for (int k = first(y); k < last(y); ++k) {
        const auto run = static_cast<uint32_t>(bits[static_cast<size_t>(i)] >> (8 * k) & 0xff);
        const uint32_t moved = z < 0 ? run >> (8 - kReach) : run << (8 * z + kReach);
        rows_[8 * x + i + kReach][8 * y + k + kReach] |= static_cast<Row>(moved);
      }
  }

  /// The dilated marks of the leaf. Rows end up in the place of the first of their window.
  LeafBits dilated() {
    each_window([&](int by) {
      for (auto& slice : rows_)
        for (Row& row : slice) row = static_cast<Row>(row | row >> by);
    });
    each_window([&](int by) {
      for (int x = 0; x + by < kSize; ++x)
        for (int y = 0; y < kSize; ++y) rows_[x][y] |= rows_[x + by][y];
    });
    each_window([&](int by) {
      for (int x = 0; x < 8; ++x)
        for (int y = 0; y + by < kSize; ++y) rows_[x][y] |= rows_[x][y + by];
    });
    LeafBits out{};
    for (size_t x = 0; x < 8; ++x)
      for (size_t y = 0; y < 8; ++y) out[x] |= uint64_t{rows_[x][y] & 0xffu} << (8 * y);
    return out;
  }

 private:
  static constexpr int kSize = 8 + 2 * kReach, kWindow = 1 + 2 * kReach;
  using Row = std::conditional_t<kSize <= 16, uint16_t, uint32_t>;

  /// The part of the leaf at -1, 0 or 1 along an axis that is in reach.
  static constexpr int first(int leaf) { return leaf < 0 ? 8 - kReach : 0; }
  static constexpr int last(int leaf) { return leaf > 0 ? kReach : 8; }

  /// A window is the union of windows of half its size, or of two that overlap.
  template <class Unite>
  static void each_window(const Unite& unite) {
    int size = 1;
    for (; 2 * size <= kWindow; size *= 2) unite(size);
    unite(kWindow - size);
  }

  Row rows_[kSize][kSize] = {};  // By x and y; bit 0 is z = -kReach.
};

/// Deactivates the voxels whose bit is not in `near(index of the leaf)`.
template <class Near>
void keep(openvdb::FloatGrid& grid, const std::vector<Leaf*>& leaves, const Near& near) {
  const float background = grid.background();
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        Leaf& leaf = *leaves[n];
        const LeafBits kept = near(n);
        for (size_t x = 0; x < 8; ++x) {
          const uint64_t on = leaf.getValueMask().getWord<uint64_t>(static_cast<openvdb::Index>(x));
          for (uint64_t gone = on & ~kept[x]; gone; gone &= gone - 1) {
            const auto at = static_cast<openvdb::Index>(64 * x) +
                            static_cast<openvdb::Index>(__builtin_ctzll(gone));
            leaf.setValueOff(at, leaf.getValue(at) < 0 ? -background : background);
          }
        }
      },
      64);
  openvdb::tools::pruneLevelSet(grid.tree());
}

template <int kReach>
void trim_near(openvdb::FloatGrid& grid) {
  const openvdb::FloatTree& tree = grid.tree();
  const SurfaceMarks marks = surface_marks(grid.tree());
  keep(grid, marks.leaves, [&](size_t n) {
    const openvdb::tree::ValueAccessor<const openvdb::FloatTree, false> at(tree);
    Neighbourhood<kReach> around;
    around.add(marks.bits[n], 0, 0, 0);
    for (int side = 0; side < 27; ++side) {
      const int x = side / 9 - 1, y = side / 3 % 3 - 1, z = side % 3 - 1;
      if (side == 13) continue;  // The leaf itself.
      if (const Leaf* leaf =
              at.probeConstLeaf(marks.leaves[n]->origin().offsetBy(8 * x, 8 * y, 8 * z)))
        around.add(marks.bits[leaf->transientData()], x, y, z);
    }
    return around.dilated();
  });
}

void trim_far(openvdb::FloatGrid& grid, int voxels) {
  const openvdb::MaskTree mask = surface_mask(grid.tree(), voxels);
  std::vector<Leaf*> leaves;
  grid.tree().getNodes(leaves);
  keep(grid, leaves, [&](size_t n) {
    LeafBits bits{};
    if (const auto* near = mask.probeConstLeaf(leaves[n]->origin()))
      for (size_t x = 0; x < 8; ++x)
        bits[x] = near->getValueMask().getWord<uint64_t>(static_cast<openvdb::Index>(x));
    return bits;
  });
}

template <int kReach = 1>
void trim(openvdb::FloatGrid& grid, int voxels) {
  if (voxels == kReach) return trim_near<kReach>(grid);
  if constexpr (kReach < kMostSteps)
    trim<kReach + 1>(grid, voxels);
  else
    trim_far(grid, voxels);
}

}  // namespace

void trim_band(openvdb::GridBase& level_set, int voxels) {
  trim(static_cast<openvdb::FloatGrid&>(level_set), voxels);
}

}  // namespace vug::volume
