// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/parallel_sort.h>
#include <vug/cells/surface.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/triangle.h>
#include <vug/mesh/weld.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace vug::cells {
namespace {

Vec3d doubled_area(const std::array<Vec3f, 3>& c) {
  return (Vec3d(c[1]) - Vec3d(c[0])).cross(Vec3d(c[2]) - Vec3d(c[0]));
}

auto as_tuple(const Vec3f& v) { return std::tuple(v.x, v.y, v.z); }

void require_consistent(const mesh::Mesh& mesh, const std::string& what) {
  mesh::validate(mesh, what);
  const mesh::Mesh whole = mesh::welded(mesh);
  const mesh::Topology topology = mesh::inspect(whole);
  if (topology.misoriented_edges > 0)
    throw Error(ErrorCode::bad_input,
                fmt::format("the polygons of {} disagree about the outside: {} edges", what,
                            topology.misoriented_edges),
                {}, "orient its polygons consistently");
}

/// The mesh's triangles that have an area, each with its smallest corner first.
std::vector<Surface::Triangle> triangles_of(const mesh::Mesh& mesh, uint32_t object) {
  std::vector<Surface::Triangle> out;
  out.reserve(mesh.triangles.size());
  for (const mesh::Triangle& t : mesh.triangles) {
    size_t first = 0;
    for (size_t k = 1; k < 3; ++k)
      if (as_tuple(mesh.positions[t[k]]) < as_tuple(mesh.positions[t[first]])) first = k;
    Surface::Triangle triangle;
    triangle.object = object;
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t vertex = t[(first + k) % 3];
      triangle.corners[k] = mesh.positions[vertex];
      triangle.normals[k] = mesh.normals.empty() ? Vec3f(0) : mesh.normals[vertex];
    }
    if (doubled_area(triangle.corners).length2() > 0) out.push_back(triangle);
  }
  return out;
}

}  // namespace

static bool operator<(const Surface::Triangle& a, const Surface::Triangle& b) {
  for (size_t k = 0; k < 3; ++k)
    if (a.corners[k] != b.corners[k]) return as_tuple(a.corners[k]) < as_tuple(b.corners[k]);
  for (size_t k = 0; k < 3; ++k)
    if (a.normals[k] != b.normals[k]) return as_tuple(a.normals[k]) < as_tuple(b.normals[k]);
  return a.object < b.object;
}

Surface::Surface(const std::vector<mesh::MeshPtr>& objects) {
  least_size_ = kInfinity;
  for (uint32_t object = 0; object < objects.size(); ++object) {
    const mesh::Mesh& mesh = *objects[object];
    const std::string what =
        objects.size() > 1 ? fmt::format("object {}", object + 1) : std::string("the object");
    require_consistent(mesh, what);
    std::vector<Triangle> own = triangles_of(mesh, object);
    if (own.empty())
      throw Error(ErrorCode::bad_input, fmt::format("{} has no surface for cells", what));
    least_size_ = std::min(least_size_, mesh::bounds(mesh).size().length());
    triangles_.insert(triangles_.end(), own.begin(), own.end());
  }
  if (triangles_.empty()) throw Error(ErrorCode::bad_input, "there is no object for cells");
  parallel_sort(triangles_.begin(), triangles_.end());
  area_ = ordered_sum(triangles_.size(), 0.0,
                      [&](size_t i) { return 0.5 * doubled_area(triangles_[i].corners).length(); });
  for (const Triangle& t : triangles_)
    for (const Vec3f& corner : t.corners) bounds_.extendBy(Vec3d(corner));
}

double Surface::area(uint32_t triangle) const {
  return 0.5 * doubled_area(triangles_[triangle].corners).length();
}

Vec3d Surface::face_normal(uint32_t triangle) const {
  return doubled_area(triangles_[triangle].corners).normalized();
}

SurfacePoint Surface::at(uint32_t triangle, double u, double v) const {
  const Triangle& t = triangles_[triangle];
  const auto mixed = [&](const std::array<Vec3f, 3>& c) {
    return Vec3d(c[0]) * (1 - u - v) + Vec3d(c[1]) * u + Vec3d(c[2]) * v;
  };
  const Vec3d face = face_normal(triangle);
  const Vec3d smooth = mixed(t.normals).normalized();  // 0 remains 0.
  return {Vec3f(mixed(t.corners)), Vec3f(smooth.dot(face) > 0.5 ? smooth : face), triangle};
}

SurfaceSearch::SurfaceSearch(const Surface& surface) : surface_(&surface) {
  std::vector<Box3d> boxes(surface.triangles().size());
  for (size_t i = 0; i < boxes.size(); ++i)
    for (const Vec3f& corner : surface.triangles()[i].corners) boxes[i].extendBy(Vec3d(corner));
  tree_ = mesh::BoxTree(boxes);
}

SurfacePoint SurfaceSearch::surface_point(uint32_t triangle, const Vec3d& point) const {
  const auto& c = surface_->triangles()[triangle].corners;
  const Vec3d a(c[0]), ab = Vec3d(c[1]) - a, ac = Vec3d(c[2]) - a, normal = ab.cross(ac);
  const double twice = normal.length2();
  const double u = (point - a).cross(ac).dot(normal) / twice;
  const double v = ab.cross(point - a).dot(normal) / twice;
  SurfacePoint place = surface_->at(triangle, u, v);
  place.position = Vec3f(point);
  return place;
}

SurfacePoint SurfaceSearch::nearest(const Vec3f& p, const SurfacePoint& from, float limit) const {
  const Vec3d target(p), normal(from.normal);
  const auto& home = surface_->triangles()[from.triangle].corners;
  const mesh::NearestOnTriangle own =
      mesh::nearest_on_triangle(target, {Vec3d(home[0]), Vec3d(home[1]), Vec3d(home[2])});
  if (own.feature == 6) return surface_point(from.triangle, own.point);
  double best = static_cast<double>(limit) * static_cast<double>(limit);
  uint32_t found = ~0u;
  Vec3d point(0);
  double facing = 0;
  tree_.visit_nearest(target, best, [&](uint32_t i) {
    const auto& c = surface_->triangles()[i].corners;
    const double agrees = surface_->face_normal(i).dot(normal);
    if (agrees < -0.2) return best;
    const Vec3d q =
        mesh::nearest_on_triangle(target, {Vec3d(c[0]), Vec3d(c[1]), Vec3d(c[2])}).point;
    const double d = (q - target).length2();
    // On a shared edge, the triangle with the most similar normal wins, then the first.
    if (d > best) return best;
    if (d == best && found != ~0u && (agrees < facing || (agrees == facing && i > found)))
      return best;
    found = i, point = q, facing = agrees;
    return best = d;
  });
  return found == ~0u ? from : surface_point(found, point);
}

std::vector<Vec3f> positions(const std::vector<SurfacePoint>& places) {
  std::vector<Vec3f> points(places.size());
  parallel_for(
      places.size(), [&](size_t i) { points[i] = places[i].position; }, 4096);
  return points;
}

}  // namespace vug::cells
