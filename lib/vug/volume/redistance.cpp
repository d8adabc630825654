// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/contact.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/redistance.h>
#include <vug/volume/surface_mask.h>

#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <cmath>

namespace vug::volume {
namespace {

using FloatLeaf = openvdb::FloatTree::LeafNodeType;

BandBlock block_of(const FloatLeaf& leaf, double voxel) {
  BandBlock block;
  for (auto on = leaf.cbeginValueOn(); on; ++on) {
    const openvdb::Coord c = on.getCoord();
    block.points.push_back(Vec3d(c.x(), c.y(), c.z()) * voxel);
    block.inside.push_back(*on < 0);
  }
  return block;
}

void set_distances(FloatLeaf& leaf, const std::vector<double>& distances, float background) {
  size_t n = 0;
  for (auto on = leaf.beginValueOn(); on; ++on, ++n) {
    const float sign = *on < 0 ? -1.0f : 1.0f;
    const auto distance = static_cast<float>(distances[n]);
    if (distance < background)
      on.setValue(sign * std::max(distance, kLeastDistance));
    else
      leaf.setValueOff(on.pos(), sign * background);
  }
}

}  // namespace

LevelSet with_distances(const LevelSet& level_set, const BlockDistances& distances,
                        Progress& progress) {
  const openvdb::FloatGrid& from = floats(level_set);
  const auto grid = from.deepCopy();
  openvdb::FloatTree& tree = grid->tree();
  const float background = grid->background();
  // Voxels within the half-width of the surface are at most one step farther from a change of sign.
  const double half_width = level_set.background() / level_set.voxel();
  const int steps = static_cast<int>(std::ceil(half_width - 1e-3)) + 1;
  tree.topologyUnion(surface_mask(tree, steps));
  std::vector<FloatLeaf*> leaves;
  tree.getNodes(leaves);
  progress.begin("exact distances", leaves.size());
  parallel_for(leaves.size(), [&](size_t n) {
    progress.check();
    const BandBlock block = block_of(*leaves[n], level_set.voxel());
    std::vector<double> found(block.points.size());
    if (!found.empty()) distances(block, found);
    set_distances(*leaves[n], found, background);
    progress.advance();
  });
  openvdb::tools::pruneLevelSet(tree);
  progress.end();
  return LevelSet(wrap(grid));
}

}  // namespace vug::volume
