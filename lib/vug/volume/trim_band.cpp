// SPDX-License-Identifier: Apache-2.0
// The surface is found and dilated with one bit for each voxel, because a lookup of each neighbour
// takes longer than the evaluation of most fields.
#include <vug/base/parallel.h>
#include <vug/volume/surface_mask.h>
#include <vug/volume/trim_band.h>

#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <vector>

namespace vug::volume {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;
using MaskLeaf = openvdb::MaskTree::LeafNodeType;

/// The most steps for which the leaves around a leaf suffice.
constexpr int kMostSteps = 8;

uint32_t shifted(uint32_t bits, int by) { return by >= 0 ? bits << by : bits >> -by; }

/// Marks within `reach` lattice steps of a leaf's voxels, gathered from it and its 26 neighbours.
class Neighbourhood {
 public:
  Neighbourhood(const openvdb::tree::ValueAccessor<const openvdb::MaskTree, false>& marks,
                const openvdb::Coord& origin, int reach)
      : reach_(reach) {
    for (int n = 0; n < 27; ++n) {
      const int x = n / 9 - 1, y = n / 3 % 3 - 1, z = n % 3 - 1;
      const MaskLeaf* leaf = marks.probeConstLeaf(origin.offsetBy(8 * x, 8 * y, 8 * z));
      if (leaf && !leaf->isEmpty()) add(*leaf, x, y, z);
    }
  }
  /// The dilated marks of the leaf, one word for each x.
  void dilate(uint64_t* words) {
    if (!any_) return std::fill(words, words + 8, uint64_t{0});
    const int size = 8 + 2 * reach_;
    for (int x = 0; x < size; ++x) {
      uint32_t along_z[kSize];
      for (int y = 0; y < size; ++y) {
        along_z[y] = 0;
        for (int step = -reach_; step <= reach_; ++step) along_z[y] |= shifted(rows_[x][y], step);
      }
      for (int y = 0; y < 8; ++y) {
        uint32_t all = 0;
        for (int step = 0; step <= 2 * reach_; ++step) all |= along_z[y + step];
        rows_[x][y] = all >> 8 & 0xff;  // Only the leaf's own z.
      }
    }
    for (int x = 0; x < 8; ++x) {
      words[x] = 0;
      for (int y = 0; y < 8; ++y) {
        uint64_t all = 0;
        for (int step = 0; step <= 2 * reach_; ++step) all |= rows_[x + step][y];
        words[x] |= all << (8 * y);
      }
    }
  }

 private:
  static constexpr int kSize = 8 + 2 * kMostSteps;

  void add(const MaskLeaf& leaf, int x, int y, int z) {
    any_ = true;
    for (int i = 0; i < 8; ++i) {
      const int at_x = 8 * x + i + reach_;
      if (at_x < 0 || at_x >= 8 + 2 * reach_) continue;
      const uint64_t word = leaf.getValueMask().getWord<uint64_t>(static_cast<openvdb::Index>(i));
      for (int k = 0; k < 8; ++k) {
        const int at_y = 8 * y + k + reach_;
        if (at_y < 0 || at_y >= 8 + 2 * reach_) continue;
        rows_[at_x][at_y] |= shifted(static_cast<uint32_t>(word >> (8 * k) & 0xff), 8 * z + 8);
      }
    }
  }

  int reach_;
  bool any_ = false;
  uint32_t rows_[kSize][kSize] = {};  // By x and y from -reach; bit 8 is z = 0.
};

/// Deactivates the voxels whose bit is not in `near(leaf, words)`.
template <class Near>
void keep(openvdb::FloatGrid& grid, const Near& near) {
  const float background = grid.background();
  std::vector<Leaf*> leaves;
  grid.tree().getNodes(leaves);
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        uint64_t words[8];
        near(*leaves[n], words);
        for (openvdb::Index x = 0; x < 8; ++x) {
          uint64_t gone = leaves[n]->getValueMask().getWord<uint64_t>(x) & ~words[x];
          for (; gone; gone &= gone - 1) {
            const auto at = 64 * x + static_cast<openvdb::Index>(__builtin_ctzll(gone));
            leaves[n]->setValueOff(at, leaves[n]->getValue(at) < 0 ? -background : background);
          }
        }
      },
      64);
  openvdb::tools::pruneLevelSet(grid.tree());
}

}  // namespace

void trim_band(openvdb::GridBase& level_set, int voxels) {
  auto& grid = static_cast<openvdb::FloatGrid&>(level_set);
  openvdb::FloatTree& tree = grid.tree();
  if (voxels > kMostSteps) {
    const openvdb::MaskTree mask = surface_mask(tree, voxels);
    return keep(grid, [&](const Leaf& leaf, uint64_t* words) {
      const MaskLeaf* near = mask.probeConstLeaf(leaf.origin());
      for (int x = 0; x < 8; ++x)
        words[x] =
            near ? near->getValueMask().getWord<uint64_t>(static_cast<openvdb::Index>(x)) : 0;
    });
  }
  const openvdb::MaskTree marks = surface_marks(tree);
  keep(grid, [&](const Leaf& leaf, uint64_t* words) {
    const openvdb::tree::ValueAccessor<const openvdb::MaskTree, false> at(marks);
    Neighbourhood(at, leaf.origin(), voxels).dilate(words);
  });
}

}  // namespace vug::volume
