// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/metrics/surface.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::metrics {
namespace {

std::optional<double> share(double part, double rest) {
  if (part + rest <= 0) return std::nullopt;
  return 100 * part / (part + rest);
}

/// Rounding error of single-precision positions, as a length.
double rounding(const mesh::Mesh& mesh) {
  const Box3d box = mesh::bounds(mesh);
  double reach = 0;
  for (int axis = 0; axis < 3 && !box.isEmpty(); ++axis)
    reach = std::max({reach, std::fabs(box.min[axis]), std::fabs(box.max[axis])});
  return reach * static_cast<double>(std::numeric_limits<float>::epsilon());
}

}  // namespace

double area(const mesh::Mesh& mesh) {
  return ordered_sum(mesh.triangles.size(), 0.0, [&](size_t face) {
    return 0.5 * mesh::double_area_vector(mesh, face).length();
  });
}

double volume(const mesh::Mesh& mesh) {
  if (mesh.positions.empty()) return 0;
  // Relative to the centre, so that meshes far from the origin lose no digits.
  const Vec3d middle = mesh::bounds(mesh).center();
  return ordered_sum(mesh.triangles.size(), 0.0, [&](size_t face) {
    const Vec3d from_middle = mesh::corners(mesh, face)[0] - middle;
    return from_middle.dot(mesh::double_area_vector(mesh, face)) / 6;
  });
}

std::optional<double> Convexity::cf() const {
  return share(static_cast<double>(convex), static_cast<double>(concave));
}
std::optional<double> Convexity::cf_area() const { return share(convex_area, concave_area); }

Convexity convexity(const mesh::Mesh& mesh, const mesh::Edges& edges) {
  const double flat = 4 * rounding(mesh);
  // Height of the corner opposite to half-edge h above the plane of `normal` at `on`.
  const auto height = [&](uint32_t h, const Vec3d& normal, const Vec3d& on) {
    const uint32_t far = mesh.triangles[h / 3][(h + 2) % 3];
    return (Vec3d(mesh.positions[far]) - on).dot(normal);
  };
  Convexity sum;
  for (const mesh::Edge& edge : edges.edges) {
    if (edge.count != 2) continue;
    const uint32_t first = edges.half_edges[edge.begin];
    const uint32_t second = edges.half_edges[edge.begin + 1];
    const Vec3d normal_1 = mesh::double_area_vector(mesh, first / 3);
    const Vec3d normal_2 = mesh::double_area_vector(mesh, second / 3);
    const Vec3d on(mesh.positions[edge.low]);
    const double height_2 = height(second, normal_1.normalized(), on);
    const double height_1 = height(first, normal_2.normalized(), on);
    if (std::max(std::fabs(height_1), std::fabs(height_2)) <= flat) continue;
    const double adjacent_area = 0.5 * (normal_1.length() + normal_2.length());
    if (height_1 + height_2 < 0) {
      ++sum.convex;
      sum.convex_area += adjacent_area;
    } else {
      ++sum.concave;
      sum.concave_area += adjacent_area;
    }
  }
  return sum;
}

}  // namespace vug::metrics
