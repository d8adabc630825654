// What is in the air as plain data: what the numbers of its grids mean.
#pragma once

#include <vug/base/vec.h>

namespace vug::exchange {

/// A cloud that dims all colours alike. Beside the grid `density` it may have `color` (its albedo),
/// `temperature` (kelvin) and `flame`. What it sends out is for each unit of length along a ray:
/// `emission`, and `heat` times what a black body of its temperature does (W/sr/m^2), both times
/// the `flame`, or where it has none times extinction and density.
struct Medium {
  double extinction = 1;  ///< Collisions per unit of length where the density is 1.
  Vec3d albedo{1, 1, 1};  ///< Share of the collisions that scatter; 1 where `color` tells it.
  double forward = 0;     ///< Mean cosine of scattering.
  Vec3d emission{0, 0, 0};
  double heat = 0;
};

}  // namespace vug::exchange
