// SPDX-License-Identifier: Apache-2.0
// The solid below a heightmap: (y - H(x, z)) / sqrt(1 + s^2), where s is the maximum slope, never
// exceeds the distance to the ground; cut to a block with four walls.
#pragma once

#include <vug/field/field.h>
#include <vug/field/heightmap.h>

#include <cmath>

namespace vug::field {

/// A source of samples for OpaqueNode.
struct Ground {
  Heightmap heightmap;
  Vec3d middle;  ///< The middle of the block along x and z; y is 0.
  Vec3d size;    ///< Edges of the block along x and z.
  double base;   ///< The bottom is y = -base.
  double shrink = 1 / std::sqrt(1 + heightmap.max_slope() * heightmap.max_slope());

  /// The height of the ground at a place of the block.
  double height(double x, double z) const;
  Gradient sample(const Vec3d& p) const;
  /// Traits of the node of this source: the gradient is at most 1 and the value a bound of the
  /// distance.
  Traits traits() const;
};

}  // namespace vug::field
