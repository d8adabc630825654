// SPDX-License-Identifier: Apache-2.0
// Dimensions of numbers: names, units, and the dimensions of products and powers.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace vug {

/// The dimension of a number. Text may contain other units; internally, lengths are in metres,
/// angles in radians, and other quantities in the units of the table in dimension.cpp.
enum class Dimension {
  none,
  length,
  angle,
  ratio,
  per_length,
  time,
  area,
  volume,
  per_area,
  frequency,
  mass,
  temperature,
  power,
  irradiance,
  luminous_flux,
  luminous_intensity,
  illuminance
};

std::string to_string(Dimension dimension);  ///< "length", "angle", "number per metre", ...

/// The internal unit as it follows a number: "m", "rad", "/m", "lm"; empty for plain numbers and
/// ratios.
std::string unit_of(Dimension dimension);

/// True for plain numbers and ratios.
bool is_plain(Dimension dimension);

/// The dimension of a product (or, with power -1, of a quotient); nothing if it is not in the
/// table.
std::optional<Dimension> product(Dimension a, Dimension b, int power = 1);

/// The dimension of a power, such as a length for the square root of an area; nothing if it is not
/// in the table.
std::optional<Dimension> raised(Dimension base, double exponent);

}  // namespace vug
