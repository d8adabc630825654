// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/folds.h>

namespace vug::meshing {

bool is_flipped(const Face& face, uint32_t k, const std::vector<Vec3d>& before,
                const std::vector<Vec3d>& after) {
  constexpr double kLeastArea = 1e-4;
  const Vec3d old = corner_normal(face, k, before);
  return corner_normal(face, k, after).dot(old) <= kLeastArea * old.length2();
}

Vec3d corner_centroid(const Face& face, uint32_t k, const std::vector<Vec3d>& points) {
  return (points[face.corners[k]] + points[face.corners[(k + 1) % face.size]] +
          points[face.corners[(k + face.size - 1) % face.size]]) /
         3.0;
}

bool faces_backwards(const Face& face, uint32_t k, const std::vector<Vec3d>& points,
                     const SurfacePoint& middle, double voxel) {
  constexpr double kReliable = 0.1;  // Voxels; further away the gradient is not reliable.
  return middle.residual < kReliable * voxel &&
         corner_normal(face, k, points).dot(middle.normal) <= 0;
}

}  // namespace vug::meshing
