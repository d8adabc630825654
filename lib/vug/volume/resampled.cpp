// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/resampled.h>

#include <fmt/format.h>
#include <openvdb/tools/Prune.h>

namespace vug::volume {
namespace {

template <class ResultGrid, class Source, class Function>
Grid resampled_on(const Source& where, const Function& value) {
  using ResultTree = typename ResultGrid::TreeType;
  using Leaf = typename ResultTree::LeafNodeType;
  const auto nothing = openvdb::zeroVal<typename ResultGrid::ValueType>();
  const auto grid = ResultGrid::create(
      typename ResultTree::Ptr(new ResultTree(where.tree(), nothing, openvdb::TopologyCopy())));
  grid->setTransform(where.transform().copy());
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->tree().voxelizeActiveTiles();
  std::vector<Leaf*> leaves;
  grid->tree().getNodes(leaves);
  parallel_for(leaves.size(), [&](size_t n) {
    for (auto voxel = leaves[n]->beginValueOn(); voxel; ++voxel) {
      const openvdb::Vec3d at = grid->indexToWorld(voxel.getCoord().asVec3d());
      voxel.setValue(stored(value(Vec3f(static_cast<float>(at.x()), static_cast<float>(at.y()),
                                        static_cast<float>(at.z())))));
    }
  });
  openvdb::tools::prune(grid->tree());
  return wrap(grid);
}

template <class ResultGrid, class Function>
Grid resampled_on(const Grid& where, const Function& value) {
  initialise_openvdb();
  const openvdb::GridBase* grid = where.data().grid.get();
  if (const auto* floats = dynamic_cast<const openvdb::FloatGrid*>(grid))
    return resampled_on<ResultGrid>(*floats, value);
  if (const auto* vectors = dynamic_cast<const openvdb::Vec3SGrid*>(grid))
    return resampled_on<ResultGrid>(*vectors, value);
  throw Error(ErrorCode::bad_input,
              fmt::format("the grid '{}' contains {}, not floats or vectors of floats",
                          where.name(), where.value_type()));
}

}  // namespace

Grid resampled(const Grid& where, const std::function<float(const Vec3f&)>& value) {
  return resampled_on<openvdb::FloatGrid>(where, value);
}
Grid resampled_vectors(const Grid& where, const std::function<Vec3f(const Vec3f&)>& value) {
  return resampled_on<openvdb::Vec3SGrid>(where, value);
}

}  // namespace vug::volume
