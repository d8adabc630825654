// SPDX-License-Identifier: Apache-2.0
// Distance between two points along a surface, estimated from their normals; infinite between the
// two sides of a thin wall.
#pragma once

#include <vug/base/vec.h>

#include <cmath>
#include <limits>

namespace vug::cells {

/// Squared distance over the surface between points a and b with unit normals. If the normals
/// differ by less than 60 degrees it is the straight-line distance. Otherwise the path crosses the
/// line in which the two tangent planes intersect: its length has the components s_a + s_b across
/// the fold and t along it. The planes of both sides of a wall never intersect, so these are
/// infinitely far apart however thin the wall; across an edge or into a corner the distance is
/// exact.
inline float surface_distance2(const Vec3f& a, const Vec3f& normal_a, const Vec3f& b,
                               const Vec3f& normal_b) {
  const Vec3f d = b - a;
  const float straight = d.length2();
  const float cosine = normal_a.dot(normal_b);
  if (cosine > 0.5f) return straight;
  const Vec3f fold = normal_a.cross(normal_b);
  const float sine2 = fold.length2();
  if (sine2 < 1e-6f) return std::numeric_limits<float>::infinity();
  const float across = std::fabs(d.dot(normal_a)) + std::fabs(d.dot(normal_b));
  const float along = d.dot(fold);
  const float bent = (across * across + along * along) / sine2;
  return bent > straight ? bent : straight;
}

}  // namespace vug::cells
