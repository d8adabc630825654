// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/tangent_planes.h>

#include <Eigen/Dense>
#include <algorithm>
#include <optional>

namespace vug::meshing {
namespace {

using Planes = std::vector<TangentPlane>;
/// Active planes: at most three.
using Heights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// The nearest point to p on all these planes; empty if they are nearly parallel, or if p is behind
/// one of them in that direction.
std::optional<Vec3d> nearest_on(const Planes& planes, const std::vector<size_t>& active,
                                const Vec3d& p) {
  const auto count = static_cast<Eigen::Index>(active.size());
  Gram gram(count, count);
  Heights heights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const TangentPlane& plane = planes[active[static_cast<size_t>(i)]];
    heights[i] = plane.height(p);
    for (Eigen::Index j = 0; j < count; ++j)
      gram(i, j) = plane.normal.dot(planes[active[static_cast<size_t>(j)]].normal);
  }
  if (gram.determinant() < 1e-6) return std::nullopt;
  const Heights steps = gram.inverse() * heights;
  if (steps.minCoeff() < 0) return std::nullopt;
  Vec3d point = p;
  for (Eigen::Index i = 0; i < count; ++i)
    point -= planes[active[static_cast<size_t>(i)]].normal * steps[i];
  return point;
}

}  // namespace

Vec3d nearest_behind(const Planes& planes, const Vec3d& p, double tolerance) {
  std::optional<Vec3d> nearest;
  double distance = kInfinity;
  for (size_t set = 1; set < size_t{1} << planes.size(); ++set) {
    std::vector<size_t> active;
    for (size_t i = 0; i < planes.size(); ++i)
      if (set >> i & 1) active.push_back(i);
    if (active.size() > 3) continue;
    const std::optional<Vec3d> point = nearest_on(planes, active, p);
    if (!point || (*point - p).length2() >= distance) continue;
    if (std::any_of(planes.begin(), planes.end(),
                    [&](const TangentPlane& each) { return each.height(*point) > tolerance; }))
      continue;
    nearest = point;
    distance = (*point - p).length2();
  }
  if (nearest) return *nearest;
  const auto farthest =
      std::max_element(planes.begin(), planes.end(),
                       [&](const auto& a, const auto& b) { return a.height(p) < b.height(p); });
  return p - farthest->normal * farthest->height(p);
}

}  // namespace vug::meshing
