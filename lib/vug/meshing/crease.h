// SPDX-License-Identifier: Apache-2.0
// Fits a point of a crease or corner to the surrounding tangent planes.
#pragma once

#include <vug/meshing/project.h>

#include <vector>

namespace vug::meshing {

/// The smallest dot product of two normals: 1 on a plane, -1 for opposite sides.
double min_normal_dot(const std::vector<SurfacePoint>& samples);

/// Minimises the sum of squared distances to the samples' tangent planes (the QEF of ju2002). In
/// directions that the planes do not determine (eigenvalues below 2 % of the largest) the point
/// stays at `anchor`.
Vec3d fit_planes(const std::vector<SurfacePoint>& samples, const Vec3d& anchor);

}  // namespace vug::meshing
