// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/data_folders.h>

#include <cstdlib>

namespace vug::loading {

std::vector<std::filesystem::path> data_folders() {
  std::vector<std::filesystem::path> folders;
  if (const char* folder = std::getenv("VUG_DATA")) folders.emplace_back(folder);
  for (const char* folder : {VUG_SOURCE_DATA, VUG_INSTALLED_DATA})
    if (std::filesystem::is_directory(folder)) folders.emplace_back(folder);
  return folders;
}

std::map<std::string, std::filesystem::path> scene_files(
    const std::vector<std::filesystem::path>& folders, const std::string& subfolder) {
  std::map<std::string, std::filesystem::path> files;
  for (const std::filesystem::path& folder : folders) {
    if (!std::filesystem::is_directory(folder / subfolder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder / subfolder))
      if (entry.path().extension() == ".vug")
        files.emplace(entry.path().stem().string(), entry.path());
  }
  return files;
}

}  // namespace vug::loading
