// SPDX-License-Identifier: Apache-2.0
// Reads a survey file of any format and computes coordinates from measurements.
#pragma once

#include <vug/survey/format.h>

namespace vug::survey {

/// The survey in a file. Throws Error(bad_input) with the line or byte of a fault; adds warnings.
Survey read_survey(const std::filesystem::path& file, const ReadOptions& options,
                   Diagnostics& warnings);

/// Writes the survey in the format of the file's extension, through a temporary file.
/// Error(bad_input) if the format is unknown or only read.
void write_survey(const Survey& survey, const std::filesystem::path& file);

}  // namespace vug::survey
