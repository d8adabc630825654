// SPDX-License-Identifier: Apache-2.0
// Reader of Walls' .srv files [@mckenzie2008].
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>

#include <string_view>

namespace vug::survey::walls {

/// The legs, walls and fixed stations of a .srv file. A prefix "a:b:" of a name becomes the survey
/// "a.b". Throws Error(bad_input) with the line, also for directives that are not supported.
Observations read(std::string_view text, const std::string& file, Diagnostics& warnings);

}  // namespace vug::survey::walls
