// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/leaf_finder.h>
#include <vug/volume/surface_mask.h>

#include <openvdb/tools/Morphology.h>

#include <immintrin.h>

namespace vug::volume {
namespace {

using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using MaskLeaf = openvdb::MaskTree::LeafNodeType;

constexpr size_t kGrain = 64;  // Leaves for each task.

/// The voxels below zero.
LeafBits inside_of(const Leaf& leaf) {
  LeafBits bits{};
  const float* values = leaf.buffer().data();
  for (size_t x = 0; x < 8; ++x)
    for (size_t y = 0; y < 8; ++y) {
      const __m256 run = _mm256_loadu_ps(values + 64 * x + 8 * y);
      const int below = _mm256_movemask_ps(_mm256_cmp_ps(run, _mm256_setzero_ps(), _CMP_LT_OQ));
      bits[x] |= static_cast<uint64_t>(below) << (8 * y);
    }
  return bits;
}

/// The bits that differ from one of their six neighbours; `before` and `after` are the leaves next
/// to this one along each axis.
LeafBits changes(const LeafBits& here, const std::array<LeafBits, 3>& before,
                 const std::array<LeafBits, 3>& after) {
  constexpr uint64_t kFirstZ = 0x0101010101010101, kLastZ = kFirstZ << 7;
  LeafBits out;
  for (size_t x = 0; x < 8; ++x) {
    const uint64_t own = here[x];
    out[x] = own ^ (x > 0 ? here[x - 1] : before[0][7]);
    out[x] |= own ^ (x < 7 ? here[x + 1] : after[0][0]);
    out[x] |= own ^ (own << 8 | before[1][x] >> 56);
    out[x] |= own ^ (own >> 8 | after[1][x] << 56);
    out[x] |= own ^ ((own & ~kLastZ) << 1 | (before[2][x] & kLastZ) >> 7);
    out[x] |= own ^ ((own & ~kFirstZ) >> 1 | (after[2][x] & kFirstZ) << 7);
  }
  return out;
}

}  // namespace

SurfaceMarks surface_marks(Tree& tree) {
  SurfaceMarks out;
  tree.getNodes(out.leaves);
  out.bits.resize(out.leaves.size());
  std::vector<LeafBits> inside(out.leaves.size());
  parallel_for(
      inside.size(),
      [&](size_t n) {
        out.leaves[n]->setTransientData(static_cast<openvdb::Index32>(n));
        inside[n] = inside_of(*out.leaves[n]);
      },
      kGrain);
  for_each_leaf(tree, out.leaves, [&](size_t n, LeafFinder& find) {
    const Leaf& leaf = *out.leaves[n];
    const auto beside = [&](size_t axis, int by) {
      openvdb::Coord origin = leaf.origin();
      origin[axis] += by;
      if (const Leaf* other = find.leaf(origin)) return inside[other->transientData()];
      LeafBits all;
      all.fill(find.value(origin) < 0 ? ~uint64_t{0} : 0);
      return all;
    };
    out.bits[n] = changes(inside[n], {beside(0, -8), beside(1, -8), beside(2, -8)},
                          {beside(0, 8), beside(1, 8), beside(2, 8)});
    for (size_t x = 0; x < 8; ++x) out.bits[n][x] &= active_bits(leaf, x);
  });
  return out;
}

openvdb::MaskTree surface_mask(Tree& level_set, int voxels) {
  const SurfaceMarks marks = surface_marks(level_set);
  openvdb::MaskTree mask(level_set, false, true, openvdb::TopologyCopy());
  std::vector<MaskLeaf*> leaves;
  mask.getNodes(leaves);
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        MaskLeaf::NodeMaskType bits;
        for (size_t x = 0; x < 8; ++x)
          bits.getWord<uint64_t>(static_cast<openvdb::Index>(x)) = marks.bits[n][x];
        leaves[n]->setValueMask(bits);
      },
      kGrain);
  openvdb::tools::dilateActiveValues(mask, voxels, openvdb::tools::NN_FACE_EDGE_VERTEX,
                                     openvdb::tools::IGNORE_TILES);
  return mask;
}

}  // namespace vug::volume
