// SPDX-License-Identifier: Apache-2.0
// Hidden names of partially written files, which contain the writing process, detection of stale
// ones, and creation of folders that can be undone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug {

/// ".NAME.PROCESS.partEXTENSION" with the id of this process. File writers derive the format from
/// the extension.
std::string partial_file_name(const std::string& name, const std::string& extension = "");

/// Partial files of that name whose process no longer exists on this host (it may still run on
/// another machine or outside the container). Empty if the folder cannot be read.
std::vector<std::filesystem::path> stale_partial_files(const std::filesystem::path& folder,
                                                       const std::string& name,
                                                       const std::string& extension = "");

/// Creates the folder and its missing parents and returns the created ones, innermost first. Throws
/// Error(io) and leaves none of them behind if one cannot be created. An empty path denotes the
/// working directory.
std::vector<std::filesystem::path> make_folders(const std::filesystem::path& folder);

/// Removes the empty ones of these folders, in order.
void remove_empty_folders(const std::vector<std::filesystem::path>& folders);

}  // namespace vug
