// The point of a crease or corner that fits the tangent planes around it.
#pragma once

#include <vug/meshing/project.h>

#include <vector>

namespace vug::meshing {

/// The smallest dot product of two normals: 1 on a plane, -1 on opposite sides.
double min_normal_dot(const std::vector<SurfacePoint>& samples);

/// Minimises the sum of squared distances to the samples' tangent planes (the QEF of ju2002).
/// In directions that the planes hardly fix (eigenvalues below 2 % of the largest) the point
/// stays where `anchor` is.
Vec3d fit_planes(const std::vector<SurfacePoint>& samples, const Vec3d& anchor);

}  // namespace vug::meshing
