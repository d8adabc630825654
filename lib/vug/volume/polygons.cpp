// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/polygons.h>

#include <openvdb/openvdb.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <limits>

namespace vug::volume {

Polygons polygons_of(const LevelSet& level_set, const PolygonOptions& options) {
  if (!(options.adaptivity >= 0 && options.adaptivity <= 1))
    throw Error(ErrorCode::bad_input, "adaptivity must be between 0 and 1");
  Polygons out;
  if (level_set.empty()) return out;
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  // For OpenVDB, values below the isovalue are inside: those that are equal are to be inside, too.
  const double iso = options.iso == 0 ? std::numeric_limits<float>::min() : options.iso;
  // OpenVDB's library contains this instantiation.
  openvdb::tools::volumeToMesh(static_cast<const openvdb::FloatGrid&>(*level_set.data().grid),
                               points, triangles, quads, iso, options.adaptivity);
  out.points.reserve(points.size()), out.triangles.reserve(triangles.size());
  out.quads.reserve(quads.size());
  for (const openvdb::Vec3s& p : points) out.points.emplace_back(p.x(), p.y(), p.z());
  // OpenVDB winds polygons clockwise seen from outside.
  for (const openvdb::Vec3I& t : triangles) out.triangles.push_back({t[2], t[1], t[0]});
  for (const openvdb::Vec4I& q : quads) out.quads.push_back({q[3], q[2], q[1], q[0]});
  return out;
}

}  // namespace vug::volume
