// SPDX-License-Identifier: Apache-2.0
// Finds the files that a survey includes.
#pragma once

#include <vug/base/error.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::survey {

/// The absolute folder without symbolic links; an empty path is the current folder.
std::filesystem::path canonical_folder(const std::filesystem::path& folder);

struct IncludeRequest {
  std::string name;  ///< As written; '\' also separates folders.
  SourceLocation where;
  const std::vector<std::filesystem::path>& files;  ///< From the first file to the including one.
  std::filesystem::path root;                       ///< The folder that files must lie in.
  bool allow_outside = false;
};

/// The file, relative to the folder of the including one: the name, the name with ".svx", and
/// both in lower case. Error(bad_input) if it does not exist, is outside of the root, or includes
/// itself.
std::filesystem::path find_included(const IncludeRequest& request);

}  // namespace vug::survey
