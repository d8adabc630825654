// SPDX-License-Identifier: Apache-2.0
// Reader of Compass .mak files: projects that list .dat files and fixed stations.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>
#include <vug/survey_files/input_files.h>

#include <string_view>

namespace vug::survey::compass {

/// The surveys of all .dat files of a project. Throws Error(bad_input) with the line.
Observations read_mak(std::string_view text, InputFiles& files, Diagnostics& warnings);

}  // namespace vug::survey::compass
