// SPDX-License-Identifier: Apache-2.0
// Presets: named values of the params of a scene, kept in a file.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace vug::workbench {

struct Preset {
  std::string name;
  bool locked = false;  ///< It can be neither replaced nor deleted.
  std::vector<std::pair<std::string, std::string>> values;  ///< Params with values as written.
};

/// The presets of one scene. Each change reads the file and writes it again, complete and flushed
/// to the disk, so that a killed program loses none and several windows share them.
class PresetStore {
 public:
  /// The file is in the folder; its name depends on the path of the scene.
  PresetStore(const std::filesystem::path& folder, const std::filesystem::path& scene);

  const std::filesystem::path& file() const { return file_; }
  /// By name.
  std::vector<Preset> all() const;
  /// Error(bad_input) with the nearest name.
  Preset find(const std::string& name) const;
  /// Adds a preset or replaces the one of that name. Error(bad_input) if it is locked, or without a
  /// name.
  void save(const Preset& preset);
  void lock(const std::string& name, bool locked);
  /// Error(bad_input) if it is locked.
  void remove(const std::string& name);

 private:
  void write(std::vector<Preset> presets) const;

  std::filesystem::path file_;
};

}  // namespace vug::workbench
