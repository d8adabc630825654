// SPDX-License-Identifier: Apache-2.0
// Reader of Compass .plt files: surveys with coordinates in feet.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/survey.h>

#include <string_view>

namespace vug::survey::compass {

/// The survey in a plot file. A station whose name is in use at other coordinates gets the name of
/// its survey as a prefix, with a warning. Throws Error(bad_input) with the line.
Survey read_plt(std::string_view text, const std::string& file, Diagnostics& warnings);

}  // namespace vug::survey::compass
