// How far two places of a surface are apart along it, judged from their normals alone.
#pragma once

#include <vug/base/vec.h>

#include <cmath>
#include <limits>

namespace vug::cells {

/// Squared distance over the surface between places a and b with unit normals. Where the normals
/// differ by less than 60 degrees it is the distance through the air. Elsewhere the way leads over
/// the line in which the two tangent planes meet: of a = s_a + s_b across the fold and of t along
/// it. Both sides of a wall have planes that never meet, so they are infinitely far apart however
/// thin the wall; across an edge or into a corner the way is exact.
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
