// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/include_search.h>

#include <algorithm>
#include <iterator>

namespace vug::scene {
namespace fs = std::filesystem;

namespace {

bool ends_with(const fs::path& path, const fs::path& ending) {
  const auto whole = std::distance(path.begin(), path.end());
  const auto part = std::distance(ending.begin(), ending.end());
  return part > 0 && part <= whole &&
         std::equal(ending.begin(), ending.end(), std::next(path.begin(), whole - part));
}

}  // namespace

std::vector<fs::path> files_below(const fs::path& folder, const fs::path& ending) {
  const fs::path wanted = ending.lexically_normal();
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const fs::path path = entry->path().lexically_relative(folder);
    std::error_code unknown;
    if (ends_with(path, wanted) && fs::is_regular_file(entry->path(), unknown))
      found.push_back(path);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace vug::scene
