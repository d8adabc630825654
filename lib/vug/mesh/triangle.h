// SPDX-License-Identifier: Apache-2.0
// The nearest point on a triangle and the feature that it lies on.
#pragma once

#include <vug/base/vec.h>

#include <array>

namespace vug::mesh {

/// Corner k is feature k, the edge from corner k to the next is 3 + k, the interior is 6.
struct NearestOnTriangle {
  Vec3d point{0, 0, 0};
  int feature = 6;
};

/// Uses the Voronoi regions of the triangle's features (ericson2005, section 5.1.5).
NearestOnTriangle nearest_on_triangle(const Vec3d& p, const std::array<Vec3d, 3>& triangle);

}  // namespace vug::mesh
