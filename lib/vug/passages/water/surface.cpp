// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/water/surface.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::passages {
namespace {

/// A corner of a prism: its place in plan and the height of the top above it.
using Corner = Vec3d;

/// The prism above a triangle in plan, with a plane through the corners as its top. Its sides are
/// moved outwards by kSeam.
void append_prism(const std::array<Corner, 3>& corners, double bottom, std::vector<Polytope>& out) {
  Vec3d up = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (std::fabs(up.y) < 1e-9) return;
  up = (up.y > 0 ? up : -up).normalized();
  Polytope part;
  part.faces.push_back({up, up.dot(corners[0])});
  double top = -kInfinity;
  for (size_t i = 0; i < 3; ++i) {
    const Vec3d &a = corners[i], &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    Vec3d out_of = in_plan(b - a).cross({0, 1, 0}).normalized();
    if (out_of.dot(c - a) > 0) out_of = -out_of;
    part.faces.push_back({out_of, out_of.dot(a) + kSeam});
    part.box.extendBy(Vec3d(a.x, bottom, a.z));
    top = std::max(top, a.y);
  }
  part.box = {part.box.min - Vec3d(kSeam, 0, kSeam), part.box.max + Vec3d(kSeam, 0, kSeam)};
  part.box.max.y = top + kSeam;
  out.push_back(std::move(part));
}

struct Edge {
  Corner left, right;
};

Edge edge_at(const SurfacePoint& point, double overlap, const Vec3d& moved = Vec3d(0.0)) {
  const auto corner = [&](double across) {
    const Vec3d p = point.position + point.place.right * across + moved;
    return Corner(p.x, point.top, p.z);
  };
  return {corner(point.place.left_wall - overlap), corner(point.place.right_wall + overlap)};
}

void append_quad(const Edge& a, const Edge& b, double bottom, std::vector<Polytope>& out) {
  append_prism({a.left, a.right, b.right}, bottom, out);
  append_prism({a.left, b.right, b.left}, bottom, out);
}

/// A level piece beyond the end of a passage.
void append_cap(const SurfacePoint& point, const Vec3d& outwards, double overlap,
                std::vector<Polytope>& out) {
  const double half = 0.5 * (point.place.right_wall - point.place.left_wall);
  const double length = std::max(half, point.place.reach) + overlap;
  append_quad(edge_at(point, overlap), edge_at(point, overlap, outwards * length),
              point.bottom - overlap, out);
}

/// The horizontal direction from a point to another, or one across the first.
Vec3d direction(const SurfacePoint& from, const SurfacePoint& to) {
  const Vec3d along = in_plan(to.position - from.position);
  if (along.length() > 1e-6) return along.normalized();
  return Vec3d(0, 1, 0).cross(from.place.right);
}

}  // namespace

void append_body(const std::vector<SurfacePoint>& points, const SurfaceOptions& options,
                 std::vector<Polytope>& out) {
  if (points.empty()) return;
  for (size_t i = 0; i + 1 < points.size(); ++i)
    append_quad(edge_at(points[i], options.overlap), edge_at(points[i + 1], options.overlap),
                std::min(points[i].bottom, points[i + 1].bottom) - options.overlap, out);
  const SurfacePoint &first = points.front(), &last = points.back();
  if (points.size() == 1) {
    const Vec3d along = Vec3d(0, 1, 0).cross(first.place.right);
    if (options.rounded_start) append_cap(first, -along, options.overlap, out);
    if (options.rounded_end) append_cap(first, along, options.overlap, out);
    return;
  }
  if (options.rounded_start) append_cap(first, -direction(first, points[1]), options.overlap, out);
  if (options.rounded_end)
    append_cap(last, direction(points[points.size() - 2], last), options.overlap, out);
}

}  // namespace vug::passages
