// What a file was made of, from the file itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug::delivery {

struct Recipe {
  std::string scene;                   ///< A scene text that makes the same again ...
  std::vector<std::string> arguments;  ///< ... with these, as "--frame 12", that no text can say.
  std::string version;                 ///< Of the Vug that made the file; may be empty.
};

/// Of a .vdb, mesh, scene of another program, picture, part of a picture or checkpoint. Overrides
/// and seed, which files keep apart, stand in the text again. Error(bad_input) for a file that
/// tells no recipe.
Recipe read_recipe(const std::filesystem::path& file);

/// The same of the text that files keep.
Recipe parse_recipe(const std::string& kept);

}  // namespace vug::delivery
