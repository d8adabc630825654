// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/crease.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace vug::meshing {

double min_normal_dot(const std::vector<SurfacePoint>& samples) {
  double least = 1;
  for (size_t i = 0; i < samples.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      least = std::min(least, samples[i].normal.dot(samples[j].normal));
  return least;
}

Vec3d fit_planes(const std::vector<SurfacePoint>& samples, const Vec3d& anchor) {
  constexpr double kLeastEigenvalue = 0.02;
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const SurfacePoint& s : samples) {
    const Eigen::Vector3d n(s.normal.x, s.normal.y, s.normal.z);
    normal_matrix += n * n.transpose();
    right += n * s.normal.dot(s.point - anchor);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal_matrix);
  const Eigen::Vector3d& values = solver.eigenvalues();  // Ascending.
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (values[k] < kLeastEigenvalue * values[2] || values[k] <= 0) continue;
    const Eigen::Vector3d axis = solver.eigenvectors().col(k);
    shift += axis * (axis.dot(right) / values[k]);
  }
  return anchor + Vec3d(shift[0], shift[1], shift[2]);
}

}  // namespace vug::meshing
