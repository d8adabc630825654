// SPDX-License-Identifier: Apache-2.0
// Search for included files below the data folders.
#pragma once

#include <filesystem>
#include <vector>

namespace vug::scene {

/// The files below the folder whose relative path ends with the components of `ending`, sorted, as
/// paths relative to the folder. Empty for an absolute `ending` and for a folder that cannot be
/// read.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::filesystem::path& ending);

}  // namespace vug::scene
