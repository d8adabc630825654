// SPDX-License-Identifier: Apache-2.0
// The folders in which includes are searched: $VUG_DATA and the scene libraries that are installed
// with Vug.
#pragma once

#include <filesystem>
#include <vector>

namespace vug::loading {

/// Folders for LoadOptions::include_folders: $VUG_DATA, then the data folders of the source tree
/// and of the installation, if they exist.
std::vector<std::filesystem::path> data_folders();

}  // namespace vug::loading
