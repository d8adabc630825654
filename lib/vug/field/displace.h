// Moves a surface along itself by a noise: value - amount * weight * noise.
#pragma once

#include <vug/field/noise.h>

#include <optional>

namespace vug::field {

struct Displacement {
  double amount = 0.1;  ///< metres at noise 1; positive noise pushes the surface outwards.
  /// Factors on the amount where the surface faces up, sideways and down.
  double floor = 1, wall = 1, ceiling = 1;
  /// Metres over which the slope is felt: (f(p + h up) - f(p - h up)) / 2h, exact to
  /// differentiate, and blind to features smaller than that.
  double feel = 0.25;
  /// Where it is -1 there is no displacement, where it is 1 all of it; nothing: all everywhere.
  std::optional<Noise> by;
};

/// The zero set moves by at most amount * |noise|; values stay Lipschitz with the stated constant
/// but are no longer a bound on the distance.
Field displaced(const Field& field, const Noise& noise, const Displacement& how);

}  // namespace vug::field
