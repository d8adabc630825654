// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/fix_covariance.h>

namespace vug::survey {
namespace {

/// The least ratio of the determinant to that of the variances alone: matrices beyond are
/// singular within the accuracy of the adjustment.
constexpr double kLeastDeterminant = 1e-9;

}  // namespace

Covariance fix_covariance(const Vec3d& deviations, const Vec3d& covariances,
                          const SourceLocation& where) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(deviations[axis] >= 1e-6 && deviations[axis] <= 1e6))
      throw Error(ErrorCode::bad_input, "a standard deviation is out of range", where,
                  "it is between 1e-6 and 1e6 metres");
  const Vec3d variances = deviations * deviations;
  const Covariance v{variances.x,   variances.y,   variances.z,
                     covariances.x, covariances.y, covariances.z};
  const double determinant = v.xx * (v.yy * v.zz - v.yz * v.yz) -
                             v.xy * (v.xy * v.zz - v.yz * v.zx) +
                             v.zx * (v.xy * v.yz - v.yy * v.zx);
  if (!(v.xx * v.yy > v.xy * v.xy && determinant > kLeastDeterminant * v.xx * v.yy * v.zz))
    throw Error(ErrorCode::bad_input, "the covariances are too large for the standard deviations",
                where, "the matrix of covariances must be positive definite");
  return v;
}

}  // namespace vug::survey
