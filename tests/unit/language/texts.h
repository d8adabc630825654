// SPDX-License-Identifier: Apache-2.0
// Texts with a marked position, and the scenes of data/.
#pragma once

#include <vug/base/atomic_file.h>
#include <vug/language/workspace.h>
#include <vug/loading/data_folders.h>
#include <vug/scene/text_at.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace vug::language {

inline WorkspaceOptions with_data() { return {loading::data_folders()}; }

/// A text with a "|", which marks a position and is not part of the text.
struct MarkedText {
  explicit MarkedText(std::string marked) : workspace(with_data()) {
    const size_t at = marked.find('|');
    if (at != std::string::npos) {
      marked.erase(at, 1);
      position.line =
          1 + static_cast<int>(std::count(marked.begin(),
                                          marked.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      const size_t begin = at == 0 ? 0 : marked.rfind('\n', at - 1) + 1;
      position.column = 1 + static_cast<int>(at - (begin > at ? 0 : begin));
    }
    text = marked;
    workspace.open("/scenes/main.vug", text);
    analysis = workspace.analyse("/scenes/main.vug");
  }
  std::string text;
  Position position;
  Workspace workspace;
  AnalysisPtr analysis;
};

inline std::string text_of(const Workspace& workspace, const SourceLocation& where) {
  const std::string text = scene::normalise_text(workspace.read(where.file).value_or(""));
  return std::string(scene::text_at(text, where));
}

/// The scenes of data/, sorted.
inline std::vector<std::filesystem::path> data_scenes() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(VUG_SOURCE_DATA))
    if (entry.path().extension() == ".vug") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

}  // namespace vug::language
