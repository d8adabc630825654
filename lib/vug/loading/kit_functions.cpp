// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/data_folders.h>
#include <vug/loading/kit_functions.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <set>

namespace vug::loading {

namespace fs = std::filesystem;

namespace {

bool declares(const fs::path& file, const std::string& function) {
  Diagnostics diagnostics;
  try {
    const scene::Document document = scene::parse_file(file, diagnostics);
    return std::any_of(document.defs.begin(), document.defs.end(),
                       [&](const scene::Def& def) { return def.name == function; });
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::string kit_file_of(const std::string& function) {
  for (const fs::path& folder : data_folders()) {
    std::error_code failed;
    std::set<fs::path> files;  // Sorted, so that every machine finds the same file.
    for (const auto& entry : fs::directory_iterator(folder / "kit", failed))
      if (entry.path().extension() == ".vug") files.insert(entry.path());
    for (const fs::path& file : files)
      if (declares(file, function)) return "kit/" + file.filename().string();
  }
  return {};
}

}  // namespace vug::loading
