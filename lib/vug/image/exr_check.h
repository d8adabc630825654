// SPDX-License-Identifier: Apache-2.0
// Validation of EXR headers before OpenImageIO reads the file.
#pragma once

#include <filesystem>
#include <string>

namespace vug::image {

/// Returns the fault in the headers of an EXR as the end of a sentence; empty for sound headers and
/// for files whose first bytes are not those of an EXR. OpenImageIO 2.4 terminates the program at a
/// channel of unknown type, so damaged files must be rejected first.
std::string exr_fault(const std::filesystem::path& path);

}  // namespace vug::image
