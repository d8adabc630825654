// SPDX-License-Identifier: Apache-2.0
// Reader of Therion's .th files [@therion2024].
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>
#include <vug/survey_files/input_files.h>

#include <string_view>

namespace vug::survey::therion {

/// The centrelines of a text and of the files that it inputs. Maps, scraps and surfaces are
/// skipped. Throws Error(bad_input) with the line.
Observations read(std::string_view text, InputFiles& files, Diagnostics& warnings);

}  // namespace vug::survey::therion
