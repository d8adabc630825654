// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/trim_band.h>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Morphology.h>
#include <openvdb/tools/Prune.h>

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

void trim_band(openvdb::GridBase& level_set, int voxels) {
  auto& grid = static_cast<openvdb::FloatGrid&>(level_set);
  Tree& tree = grid.tree();
  openvdb::MaskTree mask(tree, false, true, openvdb::TopologyCopy());
  mark_surface(tree, mask);
  openvdb::tools::dilateActiveValues(mask, voxels, openvdb::tools::NN_FACE_EDGE_VERTEX,
                                     openvdb::tools::IGNORE_TILES);
  const float background = grid.background();
  std::vector<Tree::LeafNodeType*> leaves;
  tree.getNodes(leaves);
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        const auto* near = mask.probeConstLeaf(leaves[n]->origin());
        for (auto voxel = leaves[n]->beginValueOn(); voxel; ++voxel)
          if (!near || !near->isValueOn(voxel.pos()))
            leaves[n]->setValueOff(voxel.pos(), *voxel < 0 ? -background : background);
      },
      64);
  openvdb::tools::pruneLevelSet(tree);
}

}  // namespace vug::volume
