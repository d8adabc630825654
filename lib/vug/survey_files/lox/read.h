// SPDX-License-Identifier: Apache-2.0
// Reader of Loch's .lox files.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/survey.h>

#include <string_view>

namespace vug::survey::lox {

/// The survey in the bytes of a .lox file. Stations named "." and "-" become anonymous ones, those
/// with equal coordinates are equated; the title is the first of the titles of its surveys.
/// Stations at which surface legs end are on the surface, those at which other legs end
/// underground. Surfaces, bitmaps, and shapes of cross-sections are dropped. Throws
/// Error(bad_input) with the byte offset for damaged files.
Survey read(std::string_view bytes, const std::string& file, Diagnostics& warnings);

}  // namespace vug::survey::lox
