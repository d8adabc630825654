// SPDX-License-Identifier: Apache-2.0
// Writer of Survex's .3d files.
#pragma once

#include <vug/survey/survey.h>

#include <string>

namespace vug::survey::survex3d {

/// The bytes of a .3d file of version 8 without a time stamp, so that equal surveys give equal
/// bytes. Coordinates are rounded to centimetres. The legs of traverses with a misclosure come
/// first, because the format stores a misclosure after the legs of its traverse. Comments and
/// scraps are dropped. Throws Error(bad_input) for coordinates that are not finite or exceed 21474
/// km, for cross-sections with a negative distance and for names longer than 4000 bytes.
std::string write(const Survey& survey);

}  // namespace vug::survey::survex3d
