// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/probe.h>
#include <vug/sgm/spacing.h>

#include <cmath>

namespace vug::sgm {
namespace {

/// Whether the solid contains the shape: cuts remove theirs.
bool adds(const Placement& placement) {
  return placement.effective &&
         (placement.operation == Operation::unite || placement.operation == Operation::morph);
}

/// The middle of the shape and the points of its surface in 26 directions from there.
std::vector<Vec3d> test_points(const field::Field& shape) {
  const Box3d& box = shape.bounds();
  const Vec3d middle = box.center();
  std::vector<Vec3d> points = {middle};
  const double radius = 0.5 * box.size().length();
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Vec3d outwards = Vec3d(x, y, z).normalized(), start = middle + outwards * radius;
        if (const auto t = first_hit(shape, start, -outwards, radius))
          points.push_back(start - outwards * *t);
      }
  return points;
}

}  // namespace

int owner_at(const std::vector<Placement>& placements, const Vec3d& point, double tolerance) {
  for (size_t i = placements.size(); i-- > 0;)
    if (adds(placements[i]) && placements[i].field.value(point) < tolerance)
      return static_cast<int>(i);
  return -1;
}

bool is_too_near(const field::Field& shape, const std::vector<Placement>& placements, int owner,
                 double apart) {
  if (!(apart > 0) || !is_finite(shape.bounds())) return false;
  const std::vector<Vec3d> points = test_points(shape);
  const int grandparent = owner < 0 ? -1 : placements[static_cast<size_t>(owner)].owner;
  for (size_t i = 0; i < placements.size(); ++i) {
    const Placement& other = placements[i];
    const int index = static_cast<int>(i);
    if (!adds(other) || index == owner || index == grandparent) continue;
    if (owner >= 0 && other.owner == owner) continue;
    for (const Vec3d& point : points)
      if (other.field.value(point) < apart) return true;
  }
  return false;
}

}  // namespace vug::sgm
