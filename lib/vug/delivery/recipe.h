// SPDX-License-Identifier: Apache-2.0
// Reads from a file the recipe with which it was made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug::delivery {

/// The scene text and arguments that reproduce a file.
struct Recipe {
  std::string scene;                   ///< Scene text that reproduces the file ...
  std::vector<std::string> arguments;  ///< ... with arguments such as "--frame 12".
  std::string version;                 ///< Version of Vug that made the file; may be empty.
};

/// The recipe of a .vdb file, mesh, exported scene, picture, partial render or checkpoint.
/// Overrides and seed, which files store separately, are inserted into the text. Error(bad_input)
/// for a file without a recipe.
Recipe read_recipe(const std::filesystem::path& file);

/// The recipe in the text that files store.
Recipe parse_recipe(const std::string& kept);

}  // namespace vug::delivery
