// SPDX-License-Identifier: Apache-2.0
// The point nearest to another behind a few planes, for the closest point of a surface with edges.
#pragma once

#include <vug/base/vec.h>

#include <vector>

namespace vug::meshing {

/// Points x with normal . x <= offset are behind the plane.
struct TangentPlane {
  Vec3d normal;  ///< Unit length.
  double offset = 0;

  double height(const Vec3d& x) const { return normal.dot(x) - offset; }
};

/// The point nearest to p behind all planes, which are at most four: the solution of a quadratic
/// programme, by trying all sets of up to three planes that may be active. If it has none to within
/// `tolerance` metres, the nearest point on the plane that p is farthest in front of.
Vec3d nearest_behind(const std::vector<TangentPlane>& planes, const Vec3d& p, double tolerance);

}  // namespace vug::meshing
