// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/data_folders.h>
#include <vug/loading/kit_functions.h>
#include <vug/scene/parser.h>

#include <fmt/format.h>

#include <algorithm>

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
  for (const auto& [name, file] : scene_files(data_folders(), "kit"))
    if (declares(file, function)) return fmt::format("kit/{}.vug", name);
  return {};
}

}  // namespace vug::loading
