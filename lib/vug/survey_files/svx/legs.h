// SPDX-License-Identifier: Apache-2.0
// Converts the readings of a line to a leg or a cross-section of the survey.
#pragma once

#include <vug/survey_files/svx/reader.h>

namespace vug::survey::svx {

/// Adds a leg, or an equate for a leg without length under *infer equates.
void add_leg(Reader& reader, const LegLine& line);
/// Adds a cross-section to the current tube.
void add_cross_section(Reader& reader, const StationName& station, const ItemValues& values,
                       const Line& line);

}  // namespace vug::survey::svx
