// SPDX-License-Identifier: Apache-2.0
// Archetypes of caves: scene texts in the folder `caves` of the data folders that are complete
// caves with a camera, from which new scenes start.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug::session {

/// A parameter that a scene may change.
struct ArchetypeParam {
  std::string name, value;  ///< The value as written in the text.
  std::string low, high;    ///< The range as written; empty without one.
  std::string doc;
};

struct Archetype {
  std::string name;            ///< The name of the file without its extension.
  std::filesystem::path file;  ///< The text.
  std::string doc;             ///< The first sentence of its comment.
  std::vector<ArchetypeParam> params;
  std::vector<std::string> cameras;
  std::filesystem::path thumbnail;  ///< A picture next to the text; empty: none.
};

/// All archetypes of the data folders in the order of their names. A file in an earlier folder
/// hides those of the same name in later ones. Texts without a camera are parts for other scenes,
/// not archetypes. Error(bad_input) for a text with syntax errors.
std::vector<Archetype> archetypes(const std::vector<std::filesystem::path>& data_folders);

/// The archetype of that name. Error(bad_input), with a suggestion, if there is none.
Archetype find_archetype(const std::vector<std::filesystem::path>& data_folders,
                         const std::string& name);

/// A commented scene of at most 25 lines that renders the archetype: an `include` with all of its
/// parameters and a `render` block. `file` is the name in the commands of its comment.
std::string new_scene(const Archetype& archetype, const std::string& file);

}  // namespace vug::session
