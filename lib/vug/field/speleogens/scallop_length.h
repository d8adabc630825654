// SPDX-License-Identifier: Apache-2.0
// The length of scallops as a measure of the velocity of the water that made them.
#pragma once

#include <optional>

namespace vug::field {

/// Kinematic viscosity of water of 10 degrees, in m^2/s.
inline constexpr double kWaterViscosity = 1.307e-6;

/// Mean velocity in m/s of the water in a full tube of this diameter whose scallops have this
/// Sauter mean length, both in metres (curl1974):
///   v* = 2200 nu / length,  V = v* (2.5 (ln(diameter / (2 length)) - 3/2) + 9.4).
double scallop_velocity(double length, double diameter, double viscosity = kWaterViscosity);

/// The inverse: the length of the scallops at this mean velocity, at least 1 um. Nothing for
/// water so slow that they would be longer than half of the diameter.
std::optional<double> scallop_length(double velocity, double diameter,
                                     double viscosity = kWaterViscosity);

}  // namespace vug::field
