// SPDX-License-Identifier: Apache-2.0
#include <vug/field/ground.h>

#include <algorithm>

namespace vug::field {

double Ground::height(double x, double z) const {
  return heightmap.at(x - middle.x + 0.5 * size.x, z - middle.z + 0.5 * size.z).value;
}

Gradient Ground::sample(const Vec3d& point) const {
  const Vec3d p = point - middle;
  const Heightmap::Height h = heightmap.at(p.x + 0.5 * size.x, p.z + 0.5 * size.z);
  const Gradient top = {(p.y - h.value) * shrink, Vec3d(-h.slope_u, 1, -h.slope_v) * shrink};
  const Vec3d facing(p.x < 0 ? -1 : 1, -1, p.z < 0 ? -1 : 1);
  const Vec3d wall = p * facing - Vec3d(0.5 * size.x, base, 0.5 * size.z);
  int nearest = 0;
  Vec3d off;
  for (int axis = 0; axis < 3; ++axis) {
    if (wall[axis] > wall[nearest]) nearest = axis;
    off[axis] = std::max(wall[axis], 0.0);
  }
  const double outside = off.length();
  const double cut = outside > 0 ? outside : wall[nearest];
  if (cut <= top.value) return top;
  Vec3d slope(0);
  slope[nearest] = 1;
  if (outside > 0) slope = off / outside;
  return {cut, slope * facing};
}

Traits Ground::traits() const {
  Traits traits;
  traits.exactness = Exactness::bound;
  // Above the block f >= dy / sqrt(1 + s^2), next to it f >= dx; the two combine to a diagonal.
  traits.growth = shrink / std::sqrt(2.0);
  const double highest = std::max(heightmap.range().hi, -base);
  traits.bounds = {middle + Vec3d(-0.5 * size.x, -base, -0.5 * size.z),
                   middle + Vec3d(0.5 * size.x, highest, 0.5 * size.z)};
  return traits;
}

}  // namespace vug::field
