#include <vug/meshing/folds.h>
#include <vug/meshing/project.h>

namespace vug::meshing {

bool turned_over(const Face& face, uint32_t k, const std::vector<Vec3d>& before,
                 const std::vector<Vec3d>& after) {
  constexpr double kLeastArea = 1e-4;
  const Vec3d old = corner_normal(face, k, before);
  return corner_normal(face, k, after).dot(old) <= kLeastArea * old.length2();
}

bool faces_backwards(const Face& face, uint32_t k, const std::vector<Vec3d>& points,
                     const field::Field& exact, double voxel) {
  constexpr double kOnSurface = 0.1;  // Voxels; further off, the gradient is no measure.
  const Vec3d middle = (points[face.corners[k]] + points[face.corners[(k + 1) % face.size]] +
                        points[face.corners[(k + face.size - 1) % face.size]]) /
                       3.0;
  const SurfacePoint there = probe(exact, middle);
  return there.residual < kOnSurface * voxel &&
         corner_normal(face, k, points).dot(there.normal) <= 0;
}

}  // namespace vug::meshing
