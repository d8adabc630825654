// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/polygons.h>

#include <openvdb/tools/VolumeToMesh.h>

#include <cmath>
#include <vector>

namespace vug::volume {
namespace {

using openvdb::FloatGrid;

/// A copy whose samples differ from the isovalue by at least a thousandth of a voxel. Closer ones
/// would put the vertices of several cells into the lattice point that these share, which makes
/// triangles without area. Samples that are equal to the isovalue count as inside.
FloatGrid::Ptr away_from(float iso, const FloatGrid& grid) {
  const auto least = static_cast<float>(1e-3 * grid.voxelSize().x());
  FloatGrid::Ptr copy = grid.deepCopy();
  std::vector<openvdb::FloatTree::LeafNodeType*> leaves;
  copy->tree().getNodes(leaves);
  parallel_for(
      leaves.size(),
      [&](size_t n) {
        for (auto value = leaves[n]->beginValueOn(); value; ++value)
          if (std::fabs(*value - iso) < least)
            value.setValue(*value > iso ? iso + least : iso - least);
      },
      64);
  return copy;
}

}  // namespace

Polygons polygons_of(const LevelSet& level_set, const PolygonOptions& options) {
  if (!(options.adaptivity >= 0 && options.adaptivity <= 1))
    throw Error(ErrorCode::bad_input, "adaptivity must be between 0 and 1");
  Polygons out;
  if (level_set.empty()) return out;
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  const auto& grid = static_cast<const FloatGrid&>(*level_set.data().grid);
  // OpenVDB's library contains this instantiation.
  openvdb::tools::volumeToMesh(*away_from(static_cast<float>(options.iso), grid), points, triangles,
                               quads, options.iso, options.adaptivity);
  out.points.reserve(points.size()), out.triangles.reserve(triangles.size());
  out.quads.reserve(quads.size());
  for (const openvdb::Vec3s& p : points) out.points.emplace_back(p.x(), p.y(), p.z());
  // OpenVDB winds polygons clockwise seen from outside.
  for (const openvdb::Vec3I& t : triangles) out.triangles.push_back({t[2], t[1], t[0]});
  for (const openvdb::Vec4I& q : quads) out.quads.push_back({q[3], q[2], q[1], q[0]});
  return out;
}

}  // namespace vug::volume
