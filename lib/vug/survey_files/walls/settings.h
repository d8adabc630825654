// SPDX-License-Identifier: Apache-2.0
// The #units of a Walls survey [@mckenzie2008].
#pragma once

#include <vug/base/vec.h>
#include <vug/survey_files/text_lines.h>

#include <array>
#include <string>

namespace vug::survey::walls {

/// A unit of angles; percent for gradients only.
struct AngleUnit {
  double factor = kPi / 180;  ///< Radians per unit.
  bool percent = false;
};

struct Settings {
  double distance_unit = 1;  ///< Metres; of lengths and coordinates.
  double wall_unit = 1;      ///< Metres; of distances to walls.
  AngleUnit azimuth, back_azimuth, vertical, back_vertical;
  std::string order = "dav";       ///< Columns of polar legs: distance, azimuth, vertical angle.
  std::string rect_order = "enu";  ///< Columns of rectangular legs.
  bool rectangular = false;
  double declination = 0;   ///< Radians from true to magnetic north.
  double grid = 0;          ///< Radians from true north to the north of the grid.
  double add_distance = 0;  ///< Metres, added to distances.
  double add_azimuth = 0, add_back_azimuth = 0;    ///< Radians.
  double add_vertical = 0, add_back_vertical = 0;  ///< Radians.
  bool corrected_back_azimuth = false;  ///< Backsights are given in the direction of the leg.
  bool corrected_back_vertical = false;
  bool walls_at_to = false;
  enum class Case { mixed, upper, lower } letters = Case::mixed;
  std::array<std::string, 3> prefixes;  ///< From the innermost to the outermost.
};

/// Applies the arguments of #units, the words from `first` on. SAVE and RESTORE are the reader's.
/// Error(bad_input) for unknown and unsupported settings.
void read_units(const TextLines& lines, const std::vector<Word>& words, size_t first,
                Settings& settings);

/// A distance in metres: "12.5", "12.5m", "41f", "41i6" (feet and inches). Nothing for other texts.
std::optional<double> parse_distance(std::string_view text, double unit);
/// An angle in radians: "45.5", "45:30" (minutes), "N45E", "45g" (grads), "3m" (mils), "50p".
std::optional<double> parse_angle(std::string_view text, const AngleUnit& unit);

}  // namespace vug::survey::walls
