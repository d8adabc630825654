// A look at a PNG before the system's reader sees it.
#pragma once

#include <filesystem>
#include <string>

namespace vug::image {

/// What is wrong with a PNG, as the end of a sentence: cut short, or a checksum that does not fit;
/// empty where nothing is, or where the file is none by its first bytes. libpng tells of such
/// faults on the standard error by itself, so that a damaged file must not get there.
std::string png_fault(const std::filesystem::path& path);

}  // namespace vug::image
