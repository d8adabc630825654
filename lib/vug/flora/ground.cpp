// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/flora/ground.h>
#include <vug/mesh/box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::flora {
namespace {

constexpr double kMinStep = 1e-3;       // Metres.
constexpr double kGroundDepth = 1e4;    // Metres below the top for ground without a bottom.
constexpr double kOffTheGround = 0.02;  // Start of the search upwards, metres above the ground.

/// Metres along the direction to the first value that is not above 0; infinite without one.
double free_distance(const field::Field& solid, const Vec3d& from, const Vec3d& direction,
                     double far) {
  const double steepest = std::max(solid.lipschitz(), 1e-6);
  for (double t = 0; t <= far;) {
    const double value = solid.value(from + direction * t);
    if (!(value > 0)) return t;
    t += std::max(value / steepest, kMinStep);
  }
  return kInfinity;
}

std::optional<GroundPoint> ground_point_on(const field::Field& solid, const Vec2d& at, double top,
                                           double bottom, double headroom) {
  const Vec3d down(0, -1, 0), start(at.x, top, at.y);
  double in = free_distance(solid, start, down, top - bottom);
  if (in == kInfinity || in == 0) return std::nullopt;
  double out = std::max(0.0, in - 2 * kMinStep);
  if (!(solid.value(start + down * out) > 0)) out = 0;
  for (int halving = 0; halving < 60 && in - out > 1e-9; ++halving) {
    const double middle = (in + out) / 2;
    (solid.value(start + down * middle) > 0 ? out : in) = middle;
  }
  GroundPoint point;
  point.position = start + down * in;
  const Vec3d slope = solid.gradient(point.position).gradient;
  point.normal = slope.length() > 1e-9 ? slope.normalized() : -down;
  if (headroom > kOffTheGround) {
    const Vec3d above = point.position - down * kOffTheGround;
    point.clearance = kOffTheGround + free_distance(solid, above, -down, headroom - kOffTheGround);
  }
  return point;
}

/// A tree over the triangles' projections on the plan.
struct Columns {
  mesh::MeshPtr mesh;
  mesh::BoxTree tree;

  explicit Columns(const mesh::MeshPtr& of) : mesh(of) {
    std::vector<Box3d> boxes(mesh->triangles.size());
    for (size_t i = 0; i < boxes.size(); ++i)
      for (const Vec3d& corner : mesh::corners(*mesh, i)) boxes[i].extendBy(corner);
    tree = mesh::BoxTree(boxes);
  }

  /// Barycentric coordinates of (x, z) in the triangle's projection; empty outside of it.
  std::optional<std::array<double, 3>> shares(size_t triangle, const Vec2d& at) const {
    const auto [a, b, c] = mesh::corners(*mesh, triangle);
    const Vec2d ab(b.x - a.x, b.z - a.z), ac(c.x - a.x, c.z - a.z), ap(at.x - a.x, at.y - a.z);
    const double whole = ab.cross(ac);
    if (whole == 0) return std::nullopt;
    const double v = ap.cross(ac) / whole, w = ab.cross(ap) / whole;
    if (v < 0 || w < 0 || v + w > 1) return std::nullopt;
    return std::array<double, 3>{1 - v - w, v, w};
  }

  std::optional<GroundPoint> ground_point(const Vec2d& at, const GroundOptions& options) const {
    if (tree.empty()) return std::nullopt;
    Box3d column(Vec3d(at.x, tree.bounds().min.y, at.y), Vec3d(at.x, tree.bounds().max.y, at.y));
    std::optional<GroundPoint> best;
    std::vector<double> heights;
    tree.visit_overlapping(column, [&](uint32_t triangle) {
      const auto share = shares(triangle, at);
      if (!share) return;
      const auto corners = mesh::corners(*mesh, triangle);
      GroundPoint point;
      Vec3d smooth(0);
      for (size_t i = 0; i < 3; ++i) {
        point.position += corners[i] * (*share)[i];
        if (!mesh->normals.empty())
          smooth += Vec3d(mesh->normals[mesh->triangles[triangle][i]]) * (*share)[i];
      }
      heights.push_back(point.position.y);
      const bool higher = !best || point.position.y > best->position.y;
      if (point.position.y > options.from || !higher) return;
      if (smooth.length() < 1e-6) smooth = mesh::double_area_vector(*mesh, triangle);
      point.normal = smooth.normalized();
      best = point;
    });
    if (!best) return std::nullopt;
    for (const double height : heights)
      if (height > best->position.y + kOffTheGround)
        best->clearance = std::min(best->clearance, height - best->position.y);
    return best;
  }
};

}  // namespace

Ground ground_of(const field::Field& solid, const GroundOptions& options) {
  const Box3d& box = solid.bounds();
  if (box.isEmpty()) return [](const Vec2d&) { return std::nullopt; };
  const double top = std::min(options.from, box.max.y + 1);
  if (!std::isfinite(top))
    throw Error(ErrorCode::bad_input, "the ground has no upper bound", {},
                "give the height from which to look down");
  const double bottom = std::max(box.min.y - kMinStep, top - kGroundDepth);
  return [solid, top, bottom, headroom = options.headroom](const Vec2d& at) {
    return ground_point_on(solid, at, top, bottom, headroom);
  };
}

Ground ground_of(const mesh::MeshPtr& mesh, const GroundOptions& options) {
  return [columns = std::make_shared<const Columns>(mesh), options](const Vec2d& at) {
    return columns->ground_point(at, options);
  };
}

Ground level_ground(double height) {
  return [height](const Vec2d& at) -> std::optional<GroundPoint> {
    return GroundPoint{{at.x, height, at.y}, {0, 1, 0}, kInfinity};
  };
}

}  // namespace vug::flora
