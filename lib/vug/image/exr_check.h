// A look at an EXR's headers before the system's reader sees them.
#pragma once

#include <filesystem>
#include <string>

namespace vug::image {

/// What is wrong with the headers of an EXR, as the end of a sentence; empty where nothing is, or
/// where the file is none by its first bytes. OpenImageIO 2.4 ends the program at a channel of an
/// unknown type, so that a damaged file must not get there.
std::string exr_fault(const std::filesystem::path& path);

}  // namespace vug::image
