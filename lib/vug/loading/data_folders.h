// SPDX-License-Identifier: Apache-2.0
// The folders in which includes are searched: $VUG_DATA and the scene libraries that are installed
// with Vug.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vug::loading {

/// Folders for LoadOptions::include_folders: $VUG_DATA, then the data folders of the source tree
/// and of the installation, if they exist.
std::vector<std::filesystem::path> data_folders();

/// The .vug files in a subfolder of the folders, such as "kit", by their names without extension.
/// The first folder with a file of a name provides it.
std::map<std::string, std::filesystem::path> scene_files(
    const std::vector<std::filesystem::path>& folders, const std::string& subfolder);

}  // namespace vug::loading
