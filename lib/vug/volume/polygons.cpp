#include <vug/base/error.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/polygons.h>

#include <openvdb/openvdb.h>
#include <openvdb/tools/VolumeToMesh.h>

namespace vug::volume {

Polygons polygons_of(const LevelSet& level_set, const PolygonOptions& options) {
  if (!(options.adaptivity >= 0 && options.adaptivity <= 1))
    throw Error(ErrorCode::bad_input, "adaptivity lies between 0 and 1");
  Polygons out;
  if (level_set.empty()) return out;
  openvdb::tools::VolumeToMesh mesher(options.iso, options.adaptivity);
  mesher(static_cast<const openvdb::FloatGrid&>(*level_set.data().grid));
  out.points.reserve(mesher.pointListSize());
  for (size_t i = 0; i < mesher.pointListSize(); ++i) {
    const openvdb::Vec3s& p = mesher.pointList()[i];
    out.points.emplace_back(p.x(), p.y(), p.z());
  }
  // OpenVDB winds polygons clockwise as seen from outside.
  for (size_t n = 0; n < mesher.polygonPoolListSize(); ++n) {
    const openvdb::tools::PolygonPool& pool = mesher.polygonPoolList()[n];
    for (size_t i = 0; i < pool.numQuads(); ++i) {
      const openvdb::Vec4I& q = pool.quad(i);
      out.quads.push_back({q[3], q[2], q[1], q[0]});
    }
    for (size_t i = 0; i < pool.numTriangles(); ++i) {
      const openvdb::Vec3I& t = pool.triangle(i);
      out.triangles.push_back({t[2], t[1], t[0]});
    }
  }
  return out;
}

}  // namespace vug::volume
