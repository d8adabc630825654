// SPDX-License-Identifier: Apache-2.0
#include <vug/language/includable_files.h>

#include <set>

namespace vug::language {

namespace fs = std::filesystem;

std::vector<std::string> includable_files(const Workspace& workspace, const std::string& file) {
  std::set<std::string> names;
  const auto add = [&](const fs::path& folder) {
    std::error_code failed;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied,
                                        failed);
    constexpr int kMaxDepth = 2;
    constexpr size_t kMaxFiles = 1000;
    for (; !failed && at != fs::recursive_directory_iterator() && names.size() < kMaxFiles;
         at.increment(failed)) {
      if (at.depth() >= kMaxDepth || at->path().filename().string().starts_with('.'))
        at.disable_recursion_pending();
      if (at->path().extension() == ".vug" && !is_same_file(at->path(), file))
        names.insert(at->path().lexically_relative(folder).generic_string());
    }
  };
  add(fs::path(file).parent_path().empty() ? fs::path(".") : fs::path(file).parent_path());
  for (const fs::path& folder : workspace.options().include_folders) add(folder);
  return {names.begin(), names.end()};
}

}  // namespace vug::language
