// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/surface_mask.h>

#include <openvdb/tools/Morphology.h>

#include <vector>

namespace vug::volume {
namespace {

using Tree = openvdb::FloatTree;
using openvdb::Coord;

/// Marks voxels next to a change of sign; `mask` has the leaves of the tree, in its order.
void mark_surface(const Tree& tree, openvdb::MaskTree& mask) {
  std::vector<const Tree::LeafNodeType*> leaves;
  std::vector<openvdb::MaskTree::LeafNodeType*> marks;
  tree.getNodes(leaves);
  mask.getNodes(marks);
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        const openvdb::tree::ValueAccessor<const Tree, false> at(tree);
        marks[n]->setValuesOff();
        for (auto voxel = leaves[n]->cbeginValueOn(); voxel; ++voxel) {
          const bool inside = *voxel < 0;
          for (int side = 0; side < 6; ++side) {
            Coord next = voxel.getCoord();
            next[static_cast<size_t>(side / 2)] += side % 2 ? 1 : -1;
            if ((at.getValue(next) < 0) == inside) continue;
            marks[n]->setValueOn(voxel.pos());
            break;
          }
        }
      },
      64);
}

}  // namespace

openvdb::MaskTree surface_mask(const Tree& level_set, int voxels) {
  openvdb::MaskTree mask(level_set, false, true, openvdb::TopologyCopy());
  mark_surface(level_set, mask);
  openvdb::tools::dilateActiveValues(mask, voxels, openvdb::tools::NN_FACE_EDGE_VERTEX,
                                     openvdb::tools::IGNORE_TILES);
  return mask;
}

}  // namespace vug::volume
