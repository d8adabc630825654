// SPDX-License-Identifier: Apache-2.0
// Displaces a surface along its normal by a noise: value - amount * weight * noise.
#pragma once

#include <vug/field/noise.h>

#include <optional>

namespace vug::field {

struct Displacement {
  double amount = 0.1;  ///< Metres at noise 1; positive noise pushes the surface outwards.
  /// Factors on the amount for surfaces that face up, sideways and down.
  double floor = 1, wall = 1, ceiling = 1;
  /// Step in metres of the finite difference that measures the slope: (f(p + h up) - f(p - h up)) /
  /// 2h. It is differentiated exactly and ignores features smaller than h.
  double feel = 0.25;
  /// Mask: no displacement at -1, full displacement at 1; without it full displacement everywhere.
  std::optional<Noise> by;
};

/// The zero set moves by at most amount * |noise|. Values remain Lipschitz with the stated constant
/// but no longer bound the distance.
Field displaced(const Field& field, const Noise& noise, const Displacement& options);

}  // namespace vug::field
