// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/dependencies.h>
#include <vug/scene/lexer.h>

#include <algorithm>

namespace vug::loading {
namespace fs = std::filesystem;

std::vector<fs::path> file_dependencies(const Loaded& scene) {
  std::vector<fs::path> files;
  std::error_code code;
  const auto add = [&](const fs::path& file) {
    if (fs::is_regular_file(file, code) &&
        std::find(files.begin(), files.end(), file) == files.end())
      files.push_back(file);
  };
  for (const auto& source : scene.sources) {
    const fs::path text = source->file;
    add(text);
    Diagnostics known;
    for (const scene::Token& token : scene::lex(source->text, source->file, known)) {
      if (token.kind != scene::TokenKind::text || token.faulty) continue;
      add(text.parent_path() / scene::unquote(token.text));
    }
  }
  for (const fs::path& file : scene.provenance.network_files()) add(file);
  // Those of networks from a static cache, which have names.
  for (const shot::NetworkPlan& plan : scene.shot.networks)
    for (const fs::path& file : plan.network->files) add(file);
  return files;
}

}  // namespace vug::loading
