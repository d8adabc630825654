// SPDX-License-Identifier: Apache-2.0
// Reader of Compass .dat files: surveys with readings in feet and degrees [@compass2024].
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>
#include <vug/survey_files/named_stations.h>

#include <string_view>

namespace vug::survey::compass {

/// Where the surveys of a .dat file are added.
struct DatTarget {
  Observations& observations;
  NamedStations& stations;
  double convergence = 0;  ///< Degrees from true north to the north of the grid.
};

/// Adds the surveys in a .dat file. Names of stations are common to all surveys. Throws
/// Error(bad_input) with the line.
void read_dat(std::string_view text, const std::string& file, DatTarget& target,
              Diagnostics& warnings);

}  // namespace vug::survey::compass
