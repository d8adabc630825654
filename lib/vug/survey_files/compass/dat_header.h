// SPDX-License-Identifier: Apache-2.0
// The header of a survey in a Compass .dat file.
#pragma once

#include <vug/survey/survey.h>
#include <vug/survey_files/text_lines.h>

namespace vug::survey::compass {

/// Corrections in degrees, and in feet for the length, that are added to readings.
struct Corrections {
  double bearing = 0;
  double gradient = 0;
  double length = 0;
};

struct DatHeader {
  std::string cave;
  std::string name;
  std::optional<DateRange> date;
  double declination = 0;  ///< Degrees, added to bearings.
  Corrections fore;
  Corrections back;  ///< The length is unused.
  bool has_backsights = false;
  bool sections_at_to = false;  ///< Distances to walls belong to the station TO instead of FROM.
};

/// Reads the header from the line with the cave's name, which is the current one, to the line with
/// the titles of columns. Throws Error(bad_input) with the line.
DatHeader read_dat_header(TextLines& lines);

}  // namespace vug::survey::compass
