// Where scenes find libraries that come with us.
#pragma once

#include <filesystem>
#include <vector>

namespace vug::loading {

/// For LoadOptions::include_folders: that of $VUG_DATA, then those of the sources and of the
/// installation, as far as they are there.
std::vector<std::filesystem::path> data_folders();

}  // namespace vug::loading
