// SPDX-License-Identifier: Apache-2.0
// The surface is found and dilated with one bit for each voxel, because a lookup of each neighbour
// takes longer than the evaluation of most fields.
#include <vug/volume/leaf_finder.h>
#include <vug/volume/surface_mask.h>
#include <vug/volume/trim_band.h>

#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <vector>

namespace vug::volume {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;

/// The most steps for which the leaves around a leaf suffice.
constexpr int kMostSteps = 8;

/// Moves the bits of a word by `by` steps along an axis: z is the position in a byte, y the byte.
template <int kAxis>
uint64_t moved_up(uint64_t word, int by) {
  if (kAxis == 1) return word << (8 * by);
  return (word & 0x0101010101010101 * (0xffu >> by)) << by;
}
template <int kAxis>
uint64_t moved_down(uint64_t word, int by) {
  if (kAxis == 1) return word >> (8 * by);
  return word >> by & 0x0101010101010101 * (0xffu >> by);
}

/// Calls unite(size) so that a window of `size` steps becomes the union of windows of half its
/// size, or of two that overlap.
template <class Unite>
void each_window(int window, const Unite& unite) {
  int size = 1;
  for (; 2 * size <= window; size *= 2) unite(size);
  if (window > size) unite(window - size);
}

/// Marks within `kReach` steps along y or z of a word's bits, from the word itself and from those
/// before and after it along that axis.
template <int kAxis, int kReach>
uint64_t dilated_along(uint64_t before, uint64_t own, uint64_t after) {
  constexpr int kInside = std::min(kReach, 7);
  uint64_t up = own, down = own;
  each_window(kInside + 1, [&](int by) {
    up |= moved_up<kAxis>(up, by);
    down |= moved_down<kAxis>(down, by);
  });
  uint64_t low = moved_down<kAxis>(before, 8 - kReach), high = moved_up<kAxis>(after, 8 - kReach);
  each_window(kReach, [&](int by) {
    low |= moved_down<kAxis>(low, by);
    high |= moved_up<kAxis>(high, by);
  });
  return up | down | low | high;
}

/// The marks of a leaf within `kReach` lattice steps of its own marks.
template <int kReach>
LeafBits dilated_own(const LeafBits& bits) {
  constexpr int kSize = 8 + 2 * kReach;
  uint64_t words[kSize] = {};  // Word 0 is x = -kReach.
  for (int x = 0; x < 8; ++x) {
    const uint64_t along_z = dilated_along<2, kReach>(0, bits[static_cast<size_t>(x)], 0);
    words[x + kReach] = dilated_along<1, kReach>(0, along_z, 0);
  }
  each_window(1 + 2 * kReach, [&](int by) {
    for (int x = 0; x + by < kSize; ++x) words[x] |= words[x + by];
  });
  LeafBits out;
  std::copy_n(words, 8, out.begin());
  return out;
}

/// Marks within `kReach` lattice steps of a leaf's voxels, gathered from it and its 26 neighbours.
template <int kReach>
class Neighbourhood {
 public:
  void add(const LeafBits& bits, int x, int y, int z) {
    const int first = x < 0 ? 8 - kReach : 0, last = x > 0 ? kReach : 8;
    for (int i = first; i < last; ++i)
      words_[y + 1][z + 1][8 * x + i + kReach] = bits[static_cast<size_t>(i)];
  }

  LeafBits dilated() const {
    uint64_t along_z[3][kSize], words[kSize];
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < kSize; ++x)
        along_z[y][x] = dilated_along<2, kReach>(words_[y][0][x], words_[y][1][x], words_[y][2][x]);
    for (int x = 0; x < kSize; ++x)
      words[x] = dilated_along<1, kReach>(along_z[0][x], along_z[1][x], along_z[2][x]);
    each_window(1 + 2 * kReach, [&](int by) {
      for (int x = 0; x + by < kSize; ++x) words[x] |= words[x + by];
    });
    LeafBits out;
    std::copy_n(words, 8, out.begin());
    return out;
  }

 private:
  static constexpr int kSize = 8 + 2 * kReach;
  uint64_t words_[3][3][kSize] = {};  // By y and z of the leaf; word 0 is x = -kReach.
};

bool covers(const LeafBits& bits, const Leaf& leaf) {
  for (size_t x = 0; x < 8; ++x)
    if (active_bits(leaf, x) & ~bits[x]) return false;
  return true;
}

/// Deactivates the voxels whose bit is not in `near(index of the leaf, finder)`.
template <class Near>
void keep(openvdb::FloatGrid& grid, const std::vector<Leaf*>& leaves, const Near& near) {
  const float background = grid.background();
  for_each_leaf(grid.tree(), leaves, [&](size_t n, LeafFinder& find) {
    Leaf& leaf = *leaves[n];
    const LeafBits kept = near(n, find);
    for (size_t x = 0; x < 8; ++x) {
      for (uint64_t gone = active_bits(leaf, x) & ~kept[x]; gone; gone &= gone - 1) {
        const auto at = static_cast<openvdb::Index>(64 * x) +
                        static_cast<openvdb::Index>(__builtin_ctzll(gone));
        leaf.setValueOff(at, leaf.getValue(at) < 0 ? -background : background);
      }
    }
  });
  openvdb::tools::prune(grid.tree());  // Not pruneLevelSet: tiles end without a band.
}

/// The marks of a leaf itself suffice for most leaves that the surface crosses.
template <int kReach>
void trim_near(openvdb::FloatGrid& grid) {
  const SurfaceMarks marks = surface_marks(grid.tree());
  keep(grid, marks.leaves, [&](size_t n, LeafFinder& find) {
    const Leaf& leaf = *marks.leaves[n];
    const LeafBits own = dilated_own<kReach>(marks.bits[n]);
    if (covers(own, leaf)) return own;
    Neighbourhood<kReach> around;
    around.add(marks.bits[n], 0, 0, 0);
    for (int side = 0; side < 27; ++side) {
      const int x = side / 9 - 1, y = side / 3 % 3 - 1, z = side % 3 - 1;
      if (side == 13) continue;  // The leaf itself.
      if (const Leaf* other = find.leaf(leaf.origin().offsetBy(8 * x, 8 * y, 8 * z)))
        around.add(marks.bits[other->transientData()], x, y, z);
    }
    return around.dilated();
  });
}

void trim_far(openvdb::FloatGrid& grid, int voxels) {
  const openvdb::MaskTree mask = surface_mask(grid.tree(), voxels);
  std::vector<Leaf*> leaves;
  grid.tree().getNodes(leaves);
  keep(grid, leaves, [&](size_t n, LeafFinder&) {
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
