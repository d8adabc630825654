// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/base/hash.h>
#include <vug/workbench/preset_store.h>
#include <vug/workbench/words.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace vug::workbench {
namespace {

namespace fs = std::filesystem;

void refuse_locked(const Preset& preset, const char* doing) {
  if (preset.locked)
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot {} the preset '{}': it is locked", doing, preset.name), {},
                "unlock it, or use another name");
}

/// Error(bad_input) with the nearest name.
Preset& named(std::vector<Preset>& presets, const std::string& name) {
  std::vector<std::string> names;
  for (Preset& each : presets) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("the scene has no preset '{}'", name), {},
              names.empty() ? "save one first: save_preset NAME" : suggestion(name, names));
}

/// "preset NAME locked|free PARAM VALUE ..."; nothing for other lines.
bool read_preset(const std::string& line, Preset& preset) {
  const std::vector<std::string> words = split_words(line);
  if (words.size() < 3 || words.size() % 2 == 0 || words[0] != "preset") return false;
  preset = {words[1], words[2] == "locked", {}};
  for (size_t i = 3; i + 1 < words.size(); i += 2)
    preset.values.emplace_back(words[i], words[i + 1]);
  return true;
}

}  // namespace

PresetStore::PresetStore(const fs::path& folder, const fs::path& scene) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(scene));
  file_ = folder / fmt::format("{}-{}.vugpresets", whole.stem().string(),
                               digest(whole.string()).hex().substr(0, 12));
}

std::vector<Preset> PresetStore::all() const {
  std::error_code missing;
  if (!fs::is_regular_file(file_, missing)) return {};
  std::vector<Preset> out;
  std::istringstream lines(read_text(file_));
  Preset preset;
  for (std::string line; std::getline(lines, line);)
    if (read_preset(line, preset)) out.push_back(preset);
  return out;
}

Preset PresetStore::find(const std::string& name) const {
  std::vector<Preset> presets = all();
  return named(presets, name);
}

void PresetStore::save(const Preset& preset) {
  if (preset.name.empty())
    throw Error(ErrorCode::bad_input, "a preset needs a name", {}, "such as: save_preset wide");
  std::vector<Preset> presets = all();
  for (Preset& each : presets) {
    if (each.name != preset.name) continue;
    refuse_locked(each, "replace");
    each = preset;
    return write(std::move(presets));
  }
  presets.push_back(preset);
  write(std::move(presets));
}

void PresetStore::lock(const std::string& name, bool locked) {
  std::vector<Preset> presets = all();
  named(presets, name).locked = locked;
  write(std::move(presets));
}

void PresetStore::remove(const std::string& name) {
  std::vector<Preset> presets = all();
  refuse_locked(named(presets, name), "delete");
  std::erase_if(presets, [&](const Preset& each) { return each.name == name; });
  write(std::move(presets));
}

void PresetStore::write(std::vector<Preset> presets) const {
  std::sort(presets.begin(), presets.end(),
            [](const Preset& a, const Preset& b) { return a.name < b.name; });
  std::string text = "# Presets of a scene of Vug: its params and their values.\n";
  for (const Preset& each : presets) {
    text += fmt::format("preset {} {}", quoted(each.name), each.locked ? "locked" : "free");
    for (const auto& [param, value] : each.values)
      text += fmt::format(" {} {}", quoted(param), quoted(value));
    text += '\n';
  }
  write_text(file_, text);
}

}  // namespace vug::workbench
