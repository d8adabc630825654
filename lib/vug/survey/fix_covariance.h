// SPDX-License-Identifier: Apache-2.0
// The accuracy of a fixed station as Survex and Therion state it.
#pragma once

#include <vug/survey/observations.h>

namespace vug::survey {

/// The covariance from standard deviations (metres) of x, y and z and the covariances xy, yz and zx
/// (square metres). Error(bad_input) at `where` unless the deviations are between 1e-6 and 1e6 and
/// the matrix is positive definite.
Covariance fix_covariance(const Vec3d& deviations, const Vec3d& covariances,
                          const SourceLocation& where);

}  // namespace vug::survey
