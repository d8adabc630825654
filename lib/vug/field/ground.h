// SPDX-License-Identifier: Apache-2.0
// The solid below a heightmap, cut to a block with four walls. By default its value above or below
// the ground is (y - H(x, z)) / sqrt(1 + s^2), where s is the maximum slope, which never exceeds
// the distance to the ground.
#pragma once

#include <vug/field/field.h>
#include <vug/field/heightmap.h>

#include <cmath>
#include <optional>

namespace vug::field {

/// A source of samples for OpaqueNode.
struct Ground {
  Heightmap heightmap;
  Vec3d middle;  ///< The middle of the block along x and z; y is 0.
  Vec3d size;    ///< Edges of the block along x and z.
  double base;   ///< The bottom is y = -base.
  double shrink = 1 / std::sqrt(1 + heightmap.max_slope() * heightmap.max_slope());
  /// The cosine of the slope; see with_local_slopes.
  std::optional<Heightmap> cosine{};
  double reach = 0;  ///< Metres above and below the ground within which it counts.

  /// The height of the ground at a place of the block.
  double height(double x, double z) const;
  Gradient sample(const Vec3d& p) const;
  /// Traits of the node of this source. Without `cosine`, the gradient is at most 1 and the value a
  /// bound of the distance.
  Traits traits() const;

  void add_to(Digester& digester) const { digester(heightmap, middle, size, base, cosine, reach); }

 private:
  Gradient above_ground(const Vec3d& p) const;
};

/// The same solid with (y - H) / sqrt(1 + s^2) for the slope s at the place instead of the maximum,
/// up to `reach` metres above and below the ground. The gradient at the ground is then about 1, as
/// displacements need it: with the maximum slope, one cliff stretches them everywhere. `columns`
/// and `rows` are those of the heightmap.
Ground with_local_slopes(Ground ground, int columns, int rows, double reach);

}  // namespace vug::field
