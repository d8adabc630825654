// SPDX-License-Identifier: Apache-2.0
// The vault that remains where beds of rock have fallen from the roof of a chamber.
#pragma once

#include <vug/field/field.h>
#include <vug/passages/breakdown/oriented_box.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace vug::passages {

struct VaultOptions {
  Vec3d at{0.0};           ///< The middle of the roof before the fall.
  double span = 20;        ///< Width of the roof before the fall, metres.
  double length = 20;      ///< Length of the roof across the span, metres.
  double bed = 0.6;        ///< Mean thickness of a bed, metres.
  double spacing = 1.6;    ///< Mean distance between joints, metres.
  double strength = 2.5;   ///< Bending strength of the rock, MPa.
  double density = 2650;   ///< kg / m^3.
  double azimuth = 0.4;    ///< Direction of the span in plan, radians from x to z.
  Vec3d bedding{0, 1, 0};  ///< Across the beds; need not be a unit vector.
  uint64_t seed = 0;
  /// Rock with materials: the strength of each bed is divided by 1 - H with the hardness H at its
  /// middle above `at`. Beds of hardness 1 never fall.
  std::optional<field::Field> rock = {};
};

struct Vault {
  std::vector<OrientedBox> blocks;  ///< The fallen blocks where they were, bed by bed from below.
  std::vector<double> spans;        ///< Span of the opening in each fallen bed, metres.
  std::vector<double> beds;         ///< Thickness of each fallen bed, metres.

  double volume() const;
  /// The diagonal of the largest block, metres.
  double largest() const;
};

/// The span that a bed of thickness t bridges: a beam with fixed ends, sqrt(2 S t / (rho g))
/// (white1969breakdown), in metres. The strength is in MPa.
double bridged_span(double thickness, double strength, double density);
/// The length of a ledge that remains at a wall: a cantilever, sqrt(S t / (3 rho g)).
double ledge_length(double thickness, double strength, double density);

/// From the roof upwards, each bed falls whose opening is wider than it bridges; it leaves ledges
/// of 0.3 to 1 times the longest one on both sides. Two sets of joints across the beds, with
/// lognormal distances, divide it into blocks, and those fall whose middle lies in the ellipse of
/// the opening. Throws Error(bad_input) for options out of range and Error(too_large) for more than
/// 20,000 blocks.
Vault vault(const VaultOptions& options);

/// The union of the places of all fallen blocks, 2 cm larger on each side so that they join.
field::Field vault_body(const Vault& vault);

}  // namespace vug::passages
