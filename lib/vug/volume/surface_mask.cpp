// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/surface_mask.h>

#include <openvdb/tools/Morphology.h>

#include <immintrin.h>

#include <vector>

namespace vug::volume {
namespace {

using Tree = openvdb::FloatTree;
using openvdb::Coord;
using openvdb::Index;
using MaskLeaf = openvdb::MaskTree::LeafNodeType;
using Bits = openvdb::MaskTree::LeafNodeType::NodeMaskType;

constexpr uint64_t kFirstZ = 0x0101010101010101, kLastZ = kFirstZ << 7;

uint64_t word(const Bits& bits, int x) { return bits.getWord<uint64_t>(static_cast<Index>(x)); }

/// One bit for each voxel below zero.
Bits inside_of(const Tree::LeafNodeType& leaf) {
  Bits bits;
  const float* values = leaf.buffer().data();
  for (Index x = 0; x < 8; ++x) {
    uint64_t all = 0;
    for (Index y = 0; y < 8; ++y) {
      const __m256 run = _mm256_loadu_ps(values + 64 * x + 8 * y);
      const int below = _mm256_movemask_ps(_mm256_cmp_ps(run, _mm256_setzero_ps(), _CMP_LT_OQ));
      all |= static_cast<uint64_t>(below) << (8 * y);
    }
    bits.getWord<uint64_t>(x) = all;
  }
  return bits;
}

}  // namespace

openvdb::MaskTree surface_marks(const Tree& tree) {
  openvdb::MaskTree sides(tree, false, true, openvdb::TopologyCopy()), marks(sides);
  std::vector<const Tree::LeafNodeType*> leaves;
  std::vector<MaskLeaf*> inside, marked;
  tree.getNodes(leaves);
  sides.getNodes(inside);
  marks.getNodes(marked);
  parallel_for(
      leaves.size(), [&](size_t n) { inside[n]->setValueMask(inside_of(*leaves[n])); }, 64);
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        const openvdb::tree::ValueAccessor<const openvdb::MaskTree, false> side(sides);
        const openvdb::tree::ValueAccessor<const Tree, false> value(tree);
        const auto beside = [&](int axis, int by) {
          Coord at = leaves[n]->origin();
          at[static_cast<size_t>(axis)] += by;
          if (const MaskLeaf* leaf = side.probeConstLeaf(at)) return leaf->getValueMask();
          return Bits(value.getValue(at) < 0);
        };
        const Bits here = inside[n]->getValueMask();
        const Bits before[3] = {beside(0, -8), beside(1, -8), beside(2, -8)};
        const Bits after[3] = {beside(0, 8), beside(1, 8), beside(2, 8)};
        Bits bits;
        for (int x = 0; x < 8; ++x) {
          const uint64_t own = word(here, x);
          uint64_t changes = own ^ (x > 0 ? word(here, x - 1) : word(before[0], 7));
          changes |= own ^ (x < 7 ? word(here, x + 1) : word(after[0], 0));
          changes |= own ^ (own << 8 | word(before[1], x) >> 56);
          changes |= own ^ (own >> 8 | word(after[1], x) << 56);
          changes |= own ^ ((own & ~kLastZ) << 1 | (word(before[2], x) & kLastZ) >> 7);
          changes |= own ^ ((own & ~kFirstZ) >> 1 | (word(after[2], x) & kFirstZ) << 7);
          bits.getWord<uint64_t>(static_cast<Index>(x)) =
              changes & leaves[n]->getValueMask().getWord<uint64_t>(static_cast<Index>(x));
        }
        marked[n]->setValueMask(bits);
      },
      64);
  return marks;
}

openvdb::MaskTree surface_mask(const Tree& level_set, int voxels) {
  openvdb::MaskTree mask = surface_marks(level_set);
  openvdb::tools::dilateActiveValues(mask, voxels, openvdb::tools::NN_FACE_EDGE_VERTEX,
                                     openvdb::tools::IGNORE_TILES);
  return mask;
}

}  // namespace vug::volume
