// SPDX-License-Identifier: Apache-2.0
// Validation of a PNG before libpng reads the file.
#pragma once

#include <filesystem>
#include <string>

namespace vug::image {

/// Returns the fault in a PNG as the end of a sentence: truncated, or a wrong checksum; empty for
/// sound files and for files whose first bytes are not those of a PNG. libpng prints such faults to
/// standard error itself, so damaged files must be rejected first.
std::string png_fault(const std::filesystem::path& path);

}  // namespace vug::image
