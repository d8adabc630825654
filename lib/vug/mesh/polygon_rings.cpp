// SPDX-License-Identifier: Apache-2.0
// Constrained Delaunay triangulation in the plane of the polygon, by CGAL.
#include <vug/base/error.h>
#include <vug/mesh/polygon.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <deque>

namespace vug::mesh {
namespace {

constexpr int kUnseen = -1;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<uint32_t, Kernel>;
using Sides = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Faces = CGAL::Triangulation_face_base_with_info_2<int, Kernel, Sides>;
using Data = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Plane =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data, CGAL::No_constraint_intersection_tag>;

/// Counts, for every face, the rings between it and the outside.
void count_rings(Plane& plane) {
  for (const Plane::Face_handle face : plane.all_face_handles()) face->info() = kUnseen;
  std::deque<Plane::Face_handle> queue = {plane.infinite_face()};
  plane.infinite_face()->info() = 0;
  while (!queue.empty()) {
    const Plane::Face_handle face = queue.front();
    queue.pop_front();
    for (int side = 0; side < 3; ++side) {
      const Plane::Face_handle other = face->neighbor(side);
      if (other->info() != kUnseen) continue;
      const bool crossed = face->is_constrained(side);
      other->info() = face->info() + (crossed ? 1 : 0);
      // All faces with one count are visited before those with the next.
      crossed ? queue.push_back(other) : queue.push_front(other);
    }
  }
}

}  // namespace

std::vector<Triangle> triangles_of(const std::vector<std::vector<Vec2d>>& rings) {
  Plane plane;
  uint32_t number = 0;
  try {
    for (const std::vector<Vec2d>& ring : rings) {
      std::vector<Plane::Vertex_handle> corners;
      for (const Vec2d& p : ring) {
        const size_t before = plane.number_of_vertices();
        corners.push_back(plane.insert(Kernel::Point_2(p.x, p.y)));
        if (plane.number_of_vertices() > before) corners.back()->info() = number;
        ++number;
      }
      for (size_t i = 0; i < corners.size(); ++i) {
        const auto next = corners[(i + 1) % corners.size()];
        if (corners[i] != next) plane.insert_constraint(corners[i], next);
      }
    }
  } catch (const Plane::Intersection_of_constraints_exception&) {
    throw Error(ErrorCode::bad_input, "the sides of a polygon cross each other");
  }
  std::vector<Triangle> triangles;
  if (plane.dimension() < 2) return triangles;
  count_rings(plane);
  for (const Plane::Face_handle face : plane.finite_face_handles())
    if (face->info() % 2 == 1)
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

void add_rings(Mesh& mesh, const std::vector<std::vector<uint32_t>>& rings) {
  Vec3d normal(0);
  const Vec3d origin(mesh.positions[rings.front().front()]);
  const auto& outer = rings.front();
  for (size_t i = 1; i + 1 < outer.size(); ++i)
    normal += (Vec3d(mesh.positions[outer[i]]) - origin)
                  .cross(Vec3d(mesh.positions[outer[i + 1]]) - origin);
  if (!(normal.length2() > 0)) return;
  normal.normalize();
  const Vec3d axis = std::fabs(normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d right = axis.cross(normal).normalized(), up = normal.cross(right);

  std::vector<std::vector<Vec2d>> flat;
  std::vector<uint32_t> corners;
  for (const std::vector<uint32_t>& ring : rings) {
    flat.emplace_back();
    for (const uint32_t corner : ring) {
      const Vec3d p = Vec3d(mesh.positions[corner]) - origin;
      flat.back().emplace_back(p.dot(right), p.dot(up));
      corners.push_back(corner);
    }
  }
  for (const Triangle& t : triangles_of(flat))
    mesh.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
}

}  // namespace vug::mesh
