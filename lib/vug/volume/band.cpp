// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/band.h>
#include <vug/volume/openvdb_values.h>

namespace vug::volume {
namespace {

using FloatLeaf = openvdb::FloatTree::LeafNodeType;

/// The leaves of a tree and the number of active voxels before each.
template <class Node, class GridTree>
struct Leaves {
  explicit Leaves(GridTree& tree) {
    tree.getNodes(nodes);
    for (const auto* leaf : nodes) {
      begin.push_back(count);
      count += leaf->onVoxelCount();
    }
  }
  std::vector<Node*> nodes;
  std::vector<size_t> begin;
  size_t count = 0;
};

Vec3f to_vec3f(const openvdb::Vec3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

template <class GridType, class T>
Grid filled(const LevelSet& level_set, const std::vector<T>& values) {
  initialise_openvdb();
  using GridTree = typename GridType::TreeType;
  using Value = typename GridType::ValueType;
  const openvdb::FloatGrid& source = floats(level_set);
  const Value zero = openvdb::zeroVal<Value>();
  const auto grid = GridType::create(
      typename GridTree::Ptr(new GridTree(source.tree(), zero, openvdb::TopologyCopy())));
  grid->setTransform(source.transform().copy());
  if constexpr (!std::is_integral_v<Value>) grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  const Leaves<typename GridTree::LeafNodeType, GridTree> leaves(grid->tree());
  if (leaves.count != values.size())
    throw Error(ErrorCode::internal,
                "the number of values differs from the number of voxels in the band");
  parallel_for(leaves.nodes.size(), [&](size_t n) {
    size_t at = leaves.begin[n];
    for (auto voxel = leaves.nodes[n]->beginValueOn(); voxel; ++voxel)
      voxel.setValue(stored(values[at++]));
  });
  return wrap(grid);
}

}  // namespace

BandPoints band_points(const LevelSet& level_set) {
  const openvdb::FloatGrid& grid = floats(level_set);
  const Leaves<const FloatLeaf, const openvdb::FloatTree> leaves(grid.tree());
  BandPoints out;
  out.foot.resize(leaves.count);
  out.normal.resize(leaves.count);
  parallel_for(leaves.nodes.size(), [&](size_t n) {
    const auto values = grid.getConstAccessor();
    size_t at = leaves.begin[n];
    for (auto on = leaves.nodes[n]->cbeginValueOn(); on; ++on, ++at) {
      const openvdb::Coord here = on.getCoord();
      openvdb::Vec3d slope;  // Per voxel.
      for (int axis = 0; axis < 3; ++axis) {
        openvdb::Coord step(0);
        step.setX(axis == 0).setY(axis == 1).setZ(axis == 2);
        // Values are constant beyond the band, so differences are one-sided at its edge.
        float ahead = *on, behind = *on;
        const bool more = values.isValueOn(here + step), less = values.isValueOn(here - step);
        if (more) ahead = values.getValue(here + step);
        if (less) behind = values.getValue(here - step);
        const int steps = (more ? 1 : 0) + (less ? 1 : 0);
        slope[axis] = steps > 0 ? static_cast<double>(ahead - behind) / steps : 0;
      }
      const openvdb::Vec3d up = slope.length() > 0 ? slope.unit() : openvdb::Vec3d(0, 1, 0);
      out.normal[at] = to_vec3f(up);
      out.foot[at] =
          to_vec3f(grid.indexToWorld(here.asVec3d()) - up * static_cast<double>(on.getValue()));
    }
  });
  return out;
}

std::vector<Vec3f> band_positions(const LevelSet& level_set) {
  const openvdb::FloatGrid& grid = floats(level_set);
  const Leaves<const FloatLeaf, const openvdb::FloatTree> leaves(grid.tree());
  std::vector<Vec3f> out(leaves.count);
  parallel_for(leaves.nodes.size(), [&](size_t n) {
    size_t at = leaves.begin[n];
    for (auto on = leaves.nodes[n]->cbeginValueOn(); on; ++on)
      out[at++] = to_vec3f(grid.indexToWorld(on.getCoord().asVec3d()));
  });
  return out;
}

Grid band_grid(const LevelSet& level_set, const std::vector<float>& values) {
  return filled<openvdb::FloatGrid>(level_set, values);
}
Grid band_grid(const LevelSet& level_set, const std::vector<Vec3f>& values) {
  return filled<openvdb::Vec3SGrid>(level_set, values);
}
Grid band_grid(const LevelSet& level_set, const std::vector<int32_t>& values) {
  return filled<openvdb::Int32Grid>(level_set, values);
}

}  // namespace vug::volume
