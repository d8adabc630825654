// SPDX-License-Identifier: Apache-2.0
#include <vug/field/ground.h>

#include <algorithm>

namespace vug::field {

double Ground::height(double x, double z) const {
  return heightmap.at(x - middle.x + 0.5 * size.x, z - middle.z + 0.5 * size.z).value;
}

Gradient Ground::above_ground(const Vec3d& p) const {
  const double u = p.x + 0.5 * size.x, v = p.z + 0.5 * size.z;
  const Heightmap::Height h = heightmap.at(u, v);
  const double above = p.y - h.value;
  const Vec3d slope(-h.slope_u, 1, -h.slope_v);
  if (!cosine) return {above * shrink, slope * shrink};
  // above * w within the reach, and a slope of `shrink` beyond it.
  const Heightmap::Height w = cosine->at(u, v);
  const double near = std::clamp(above, -reach, reach), more = w.value - shrink;
  return {above * shrink + near * more,
          slope * (near == above ? w.value : shrink) + Vec3d(w.slope_u, 0, w.slope_v) * near};
}

Gradient Ground::sample(const Vec3d& point) const {
  const Vec3d p = point - middle;
  const Gradient top = above_ground(p);
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
  if (cosine) {
    traits.exactness = Exactness::sign;
    const double slope = heightmap.max_slope();
    traits.lipschitz =
        cosine->range().hi * std::sqrt(1 + slope * slope) + reach * cosine->max_slope();
  }
  // Above the block f >= dy / sqrt(1 + s^2), next to it f >= dx; the two combine to a diagonal.
  traits.growth = shrink / std::sqrt(2.0);
  const double highest = std::max(heightmap.range().hi, -base);
  traits.bounds = {middle + Vec3d(-0.5 * size.x, -base, -0.5 * size.z),
                   middle + Vec3d(0.5 * size.x, highest, 0.5 * size.z)};
  return traits;
}

Ground with_local_slopes(Ground ground, int columns, int rows, double reach) {
  std::vector<float> cosines;
  cosines.reserve(static_cast<size_t>(columns) * static_cast<size_t>(rows));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Heightmap::Height h = ground.heightmap.at(ground.size.x * column / (columns - 1),
                                                      ground.size.z * row / (rows - 1));
      const double squared = 1 + h.slope_u * h.slope_u + h.slope_v * h.slope_v;
      // Not less than the factor of the maximum slope, which bounds the value from below.
      cosines.push_back(
          static_cast<float>(std::max(1 / std::sqrt(squared), ground.shrink * (1 + 1e-6))));
    }
  ground.cosine = Heightmap(columns, rows, std::move(cosines), ground.size.x, ground.size.z,
                            Sampling::bilinear);
  ground.reach = reach;
  return ground;
}

}  // namespace vug::field
