// SPDX-License-Identifier: Apache-2.0
// Calibrates the readings of a leg and computes its vector in each data style.
#pragma once

#include <vug/survey/measurement.h>
#include <vug/survey_files/svx/reader.h>

namespace vug::survey::svx {

struct LegVector {
  MeasuredVector measured;
  double length = 0;  ///< As measured, in metres.
};

/// The vector from the line's first to its second station. Error(bad_input) if a reading is missing
/// or contradicts another; warnings for suspicious ones.
LegVector leg_vector(Reader& reader, const LegLine& line);

}  // namespace vug::survey::svx
