// SPDX-License-Identifier: Apache-2.0
// Reads a survey file of any format and computes coordinates from measurements.
#pragma once

#include <vug/survey_files/format.h>

namespace vug::survey {

/// The survey in a file. Throws Error(bad_input) with the line or byte of a fault, also
/// if the survey has no stations; adds warnings.
Survey read_survey(const std::filesystem::path& file, const ReadOptions& options,
                   Diagnostics& warnings);

/// The format of a file's extension. Error(bad_input) if it is unknown or only read.
const Format& writable_format_of(const std::filesystem::path& file);

/// Writes the survey in the format of the file's extension, through a temporary file.
/// Error(bad_input) as above.
void write_survey(const Survey& survey, const std::filesystem::path& file);

}  // namespace vug::survey
