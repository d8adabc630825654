// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/probe.h>
#include <vug/sgm/spacing.h>

#include <algorithm>

namespace vug::sgm {
namespace {

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

bool adds(const Placement& placement) {
  return placement.effective &&
         (placement.operation == Operation::unite || placement.operation == Operation::morph);
}

int owner_at(const PlacedShapes& placed, const Vec3d& point, double tolerance) {
  int owner = -1;
  placed.boxes.any_meeting(grown(Box3d(point), tolerance), [&](int index) {
    if (index > owner &&
        placed.placements[static_cast<size_t>(index)].field.value(point) < tolerance)
      owner = index;
    return false;
  });
  return owner;
}

bool is_too_near(const Placement& shape, const PlacedShapes& placed, double apart) {
  if (!(apart > 0) || !is_finite(shape.field.bounds())) return false;
  const std::vector<Vec3d> points = test_points(shape.field);
  Box3d box;
  for (const Vec3d& point : points) box.extendBy(point);
  const auto& all = placed.placements;
  return placed.boxes.any_meeting(grown(box, apart), [&](int index) {
    const Placement& other = all[static_cast<size_t>(index)];
    for (const int owner : {shape.owner, shape.other_end})
      if (owner >= 0 && (index == owner || index == all[static_cast<size_t>(owner)].owner ||
                         other.owner == owner || other.other_end == owner))
        return false;
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3d& point) { return other.field.value(point) < apart; });
  });
}

}  // namespace vug::sgm
