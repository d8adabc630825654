// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/surface_mask.h>
#include <vug/volume/trim_band.h>

#include <openvdb/tools/Prune.h>

#include <vector>

namespace vug::volume {

void trim_band(openvdb::GridBase& level_set, int voxels) {
  auto& grid = static_cast<openvdb::FloatGrid&>(level_set);
  openvdb::FloatTree& tree = grid.tree();
  const openvdb::MaskTree mask = surface_mask(tree, voxels);
  const float background = grid.background();
  std::vector<openvdb::FloatTree::LeafNodeType*> leaves;
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
