// SPDX-License-Identifier: Apache-2.0
// The vector of a leg from calibrated readings.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey_files/therion/data_line.h>

namespace vug::survey::therion {

struct LegVector {
  MeasuredVector measured;
  double length = 0;  ///< Metres.
};

/// The vector of a line in the style of the settings. Fore and back readings are averaged,
/// with a warning if they differ by more than three standard deviations. Error(bad_input) if a
/// reading is missing or out of range.
LegVector leg_vector(const DataLine& line, const Settings& settings, Diagnostics& warnings);

}  // namespace vug::survey::therion
