// SPDX-License-Identifier: Apache-2.0
// Layers of calcite on floors and walls, as plain data, and the field of their thickness.
#pragma once

#include <vug/field/field.h>

#include <cstdint>
#include <vector>

namespace vug::field {

/// All layers of a kind have the same proportions between two limits.
struct LayerShape {
  double slenderness = 0.25;              ///< The thickness over the half-width.
  double narrowest = 0.02, widest = 0.8;  ///< Limits of the half-width in metres.
  double thickest = 0.2;                  ///< Metres.
};

/// A layer along a segment: the thickness falls from the middle to 0 at the half-width, as
/// (1 - (d / half-width)^2)^2 over the distance d to the segment. A segment without a length is a
/// round layer.
struct Deposit {
  int64_t drip = 0;  ///< The id of the source of its water.
  Vec3d from{0.0}, to{0.0};
  double half_width_from = 0, half_width_to = 0;  ///< Metres.
  double thickness_from = 0, thickness_to = 0;    ///< In the middle, metres.

  /// The layer between two points on whose ends cross-sections in m2 were deposited.
  static Deposit along(int64_t drip, const Vec3d& from, const Vec3d& to, double section_from,
                       double section_to, const LayerShape& shape);
  /// A round layer of that volume in m3.
  static Deposit around(int64_t drip, const Vec3d& at, double volume, const LayerShape& shape);
};

/// The integral of the profile across a layer of thickness 1 and half-width 1, and over a round
/// one.
inline constexpr double kSectionShare = 16.0 / 15, kRoundShare = 1.0471975511965976;

/// Greatest slope and value of the thickness of any deposits; steeper and thicker ones are made
/// thinner.
inline constexpr double kSteepestDeposit = 0.7, kThickestDeposit = 0.25;

/// The greatest thickness of the deposits at a point, in metres, 0 far from all of them.
Field thickness_field(std::vector<Deposit> deposits);

}  // namespace vug::field
