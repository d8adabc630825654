// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/loading/scouted_cameras.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::loading {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKey = "scout";
constexpr double kMostShots = 999;

const scene::Entry* scout_entry(const scene::Declaration& declaration) {
  return declaration.kind == "camera" && !declaration.broken ? declaration.find_entry(kKey)
                                                             : nullptr;
}

/// The number of the shot; 0 for other values.
size_t shot_number(const scene::Entry& entry) {
  if (entry.values.size() != 1) return 0;
  const scene::Expr& value = *entry.values[0];
  const double number = value.number.value;
  const bool whole = value.kind == scene::ExprKind::number &&
                     value.number.dimension == Dimension::none && number == std::floor(number);
  return whole && number >= 1 && number <= kMostShots ? static_cast<size_t>(number) : 0;
}

/// The name of the module that contains the shot; a camera of a module has a dot in its name.
std::string module_name(const scene::Declaration& declaration) {
  std::string name = declaration.name + "_shot";
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

}  // namespace

fs::path shots_folder(const fs::path& scene) {
  return scene.parent_path() / (scene.stem().string() + "_shots");
}

std::string shot_file(size_t number) { return fmt::format("shot{}.vug", number); }

std::vector<std::string> scouted_includes(const scene::Document& document, const fs::path& scene,
                                          Diagnostics& diagnostics) {
  std::vector<std::string> statements;
  for (const scene::Declaration& each : document.declarations) {
    const scene::Entry* entry = scout_entry(each);
    if (!entry) continue;
    const size_t number = shot_number(*entry);
    if (number == 0) {
      diagnostics.error(entry->extent, "'scout' takes the number of a shot, from 1",
                        "write camera main { scout 3 }");
      continue;
    }
    if (each.entries.size() > 1 || each.loop) {
      diagnostics.error(each.where, "a camera with 'scout' has no other values",
                        "copy the camera from the file of the shot, and change it");
      continue;
    }
    const fs::path file = shots_folder(scene) / shot_file(number);
    std::error_code failed;
    if (!fs::is_regular_file(file, failed)) {
      diagnostics.error(entry->extent,
                        fmt::format("the scene has no shot {}: '{}' does not exist", number,
                                    file.generic_string()),
                        fmt::format("find the shots with: vug scout {}", scene.generic_string()));
      continue;
    }
    statements.push_back(fmt::format("include \"{}/{}\" as {}\n",
                                     shots_folder(scene).filename().generic_string(),
                                     shot_file(number), module_name(each)));
  }
  return statements;
}

void use_scouted_cameras(scene::Document& document) {
  for (scene::Declaration& each : document.declarations) {
    const scene::Entry* entry = scout_entry(each);
    if (!entry) continue;
    scene::Expr name;
    name.kind = scene::ExprKind::name;
    name.extent = name.where = entry->extent;
    name.text = fmt::format("{}.shot{}", module_name(each), shot_number(*entry));
    each.value = std::make_shared<const scene::Expr>(std::move(name));
    each.entries.clear();
  }
}

void forget_scouted_cameras(scene::Document& document) {
  for (scene::Declaration& each : document.declarations)
    if (scout_entry(each)) each.entries.clear();
}

}  // namespace vug::loading
