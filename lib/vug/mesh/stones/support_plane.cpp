// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/stones/support_plane.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

constexpr int kMostPivots = 200;

/// Twice the signed area of a triangle of the plan.
double area(const Gap& a, const Gap& b, const Gap& c) {
  return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

/// Barycentric weights of a point.
std::array<double, 3> weights(const std::array<Gap, 3>& t, const Gap& p) {
  const double whole = area(t[0], t[1], t[2]);
  return {area(p, t[1], t[2]) / whole, area(t[0], p, t[2]) / whole, area(t[0], t[1], p) / whole};
}

SupportPlane plane_through(const std::array<Gap, 3>& t) {
  const double x1 = t[1].x - t[0].x, z1 = t[1].z - t[0].z, h1 = t[1].height - t[0].height;
  const double x2 = t[2].x - t[0].x, z2 = t[2].z - t[0].z, h2 = t[2].height - t[0].height;
  const double whole = x1 * z2 - x2 * z1;
  SupportPlane plane;
  plane.slope_x = (h1 * z2 - h2 * z1) / whole;
  plane.slope_z = (x1 * h2 - x2 * h1) / whole;
  plane.drop = t[0].height - plane.slope_x * t[0].x - plane.slope_z * t[0].z;
  return plane;
}

}  // namespace

SupportPlane support_plane(const std::vector<Gap>& gaps, double reach, double limit) {
  // Three outriggers, far away at the corners of a triangle around the body, limit the slope.
  double least = 0;
  if (!gaps.empty()) {
    least = gaps[0].height;
    for (const Gap& gap : gaps) least = std::min(least, gap.height);
  }
  const double far = 3 * reach, height = least + limit * far, root = 0.5 * std::sqrt(3.0);
  std::array<Gap, 3> basis = {{{far, 0, height, 0},
                               {-0.5 * far, root * far, height, 0},
                               {-0.5 * far, -root * far, height, 0}}};
  SupportPlane plane = plane_through(basis);
  std::array<int, 3> contacts{-1, -1, -1};
  const double slack = 1e-12 * reach;
  for (int pivot = 0; pivot < kMostPivots; ++pivot) {
    int enters = -1;
    double worst = -slack;
    for (size_t i = 0; i < gaps.size(); ++i) {
      const Gap& g = gaps[i];
      const double left = g.height - plane.drop - plane.slope_x * g.x - plane.slope_z * g.z;
      if (left >= worst) continue;
      worst = left;
      enters = static_cast<int>(i);
    }
    if (enters < 0) break;
    const Gap& in = gaps[static_cast<size_t>(enters)];
    const std::array<double, 3> own = weights(basis, {}), other = weights(basis, in);
    size_t leaves = 3;
    double ratio = 0;
    for (size_t k = 0; k < 3; ++k) {
      if (other[k] <= 1e-12) continue;
      const double r = own[k] / other[k];
      if (leaves < 3 && r >= ratio) continue;
      ratio = r;
      leaves = k;
    }
    if (leaves == 3) break;
    std::array<Gap, 3> next = basis;
    next[leaves] = in;
    if (std::fabs(area(next[0], next[1], next[2])) < 1e-14 * reach * reach) break;
    basis = next;
    contacts[leaves] = enters;
    plane = plane_through(basis);
  }
  plane.contacts = contacts;
  return plane;
}

}  // namespace vug::mesh
