// SPDX-License-Identifier: Apache-2.0
// A participating medium as plain data: the meaning of the grids of a volume.
#pragma once

#include <vug/base/vec.h>

namespace vug::exchange {

/// A medium with grey extinction. In addition to the grid `density` it may have `color` (the
/// albedo), `temperature` (kelvin) and `flame`. Its emission per unit length along a ray is
/// `emission`, plus `heat` times the radiance of a black body of its temperature (W/sr/m^2); both
/// are multiplied by `flame`, or by extinction and density if there is no such grid.
struct Medium {
  double extinction = 1;  ///< Extinction coefficient per unit length at density 1.
  Vec3d albedo{1, 1, 1};  ///< Single-scattering albedo; 1 if the grid `color` provides it.
  double forward = 0;     ///< Mean cosine of scattering (the parameter g).
  Vec3d emission{0, 0, 0};
  double heat = 0;
};

}  // namespace vug::exchange
