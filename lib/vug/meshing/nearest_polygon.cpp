// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/triangle.h>
#include <vug/meshing/nearest_polygon.h>

namespace vug::meshing {
namespace {

std::vector<Box3d> boxes_of(const FaceMesh& mesh) {
  std::vector<Box3d> boxes(mesh.faces.size());
  for (size_t f = 0; f < boxes.size(); ++f)
    for (uint32_t k = 0; k < mesh.faces[f].size; ++k)
      boxes[f].extendBy(mesh.points[mesh.faces[f].corners[k]]);
  return boxes;
}

}  // namespace

NearestPolygon::NearestPolygon(const FaceMesh& mesh) : mesh_(mesh), boxes_(boxes_of(mesh)) {}

std::array<Vec3d, 3> NearestPolygon::triangle(const Face& face, uint32_t half) const {
  const auto& c = face.corners;
  return {mesh_.points[c[0]], mesh_.points[c[half + 1]], mesh_.points[c[half + 2]]};
}

NearestPolygon::Found NearestPolygon::find(const Vec3d& p, double limit) const {
  Found nearest{p};
  double best = limit * limit;
  uint32_t at = UINT32_MAX;
  boxes_.visit_nearest(p, best, [&](uint32_t f) {
    const Face& face = mesh_.faces[f];
    for (uint32_t half = 0; half + 2 < face.size; ++half) {
      const Vec3d point = mesh::nearest_on_triangle(p, triangle(face, half)).point;
      const double squared = (point - p).length2();
      // The lower number wins among equal distances, so the result is unique.
      if (squared > best || (squared == best && f >= at)) continue;
      best = squared;
      at = f;
      nearest = {point, &face};
    }
    return best;
  });
  return nearest;
}

}  // namespace vug::meshing
