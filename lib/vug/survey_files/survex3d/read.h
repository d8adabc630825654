// SPDX-License-Identifier: Apache-2.0
// Reader of Survex's .3d files.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/survey.h>

#include <string_view>

namespace vug::survey::survex3d {

/// The survey in the bytes of a .3d file of version 8. The end of a leg is the station at the same
/// coordinates, if possible one of the leg's survey; without such a station it is an anonymous
/// one. Named stations with equal coordinates are equated. Throws Error(bad_input) with the byte
/// offset for other versions and for damaged files.
Survey read(std::string_view bytes, const std::string& file, Diagnostics& warnings);

}  // namespace vug::survey::survex3d
