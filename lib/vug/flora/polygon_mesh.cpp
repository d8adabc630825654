// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/flora/polygon_mesh.h>
#include <vug/flora/self_intersection.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/polygon.h>
#include <vug/mesh/weld.h>

#include <fmt/format.h>

namespace vug::flora {
namespace {

void require_simple_polygon(const lsystem::Polygon& polygon, size_t number) {
  const std::optional<SelfIntersection> fault =
      find_self_intersection(polygon.corners, Touching::allowed);
  if (!fault) return;
  throw Error(
      ErrorCode::bad_input,
      fmt::format("polygon {} that the turtle draws crosses itself: sides {} and {} at "
                  "({:.6g}, {:.6g}, {:.6g})",
                  number, fault->first, fault->second, fault->at.x, fault->at.y, fault->at.z),
      {}, "close it with '}' before the line crosses, or draw several polygons");
}

}  // namespace

mesh::Mesh polygon_mesh(const lsystem::Drawing& drawing) {
  mesh::Mesh mesh;
  mesh::Attribute order{"order", 1, {}}, colour{"colour", 1, {}};
  size_t number = 0;
  for (const lsystem::Polygon& polygon : drawing.polygons) {
    require_simple_polygon(polygon, ++number);
    std::vector<uint32_t> corners;
    Vec3d area(0);  // Newell's normal, independent of the triangulation.
    for (size_t i = 0; i < polygon.corners.size(); ++i) {
      const Vec3d& a = polygon.corners[i];
      const Vec3d& b = polygon.corners[(i + 1) % polygon.corners.size()];
      area += (a - polygon.corners[0]).cross(b - polygon.corners[0]);
      corners.push_back(static_cast<uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(a);
    }
    if (area.length() > 0)
      mesh::add_polygon(mesh, corners);
    else
      mesh.positions.resize(mesh.positions.size() - corners.size());
    const size_t more = mesh.positions.size() - order.values.size();
    order.values.insert(order.values.end(), more, static_cast<float>(polygon.order));
    colour.values.insert(colour.values.end(), more, static_cast<float>(polygon.colour));
  }
  mesh.attributes = {std::move(order), std::move(colour)};
  mesh = mesh::welded(mesh);
  mesh.normals = mesh::vertex_normals(mesh);
  return mesh;
}

}  // namespace vug::flora
