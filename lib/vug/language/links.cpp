// SPDX-License-Identifier: Apache-2.0
#include <vug/language/links.h>
#include <vug/scene/include_search.h>

#include <optional>

namespace vug::language {

namespace fs = std::filesystem;

namespace {

/// The file that an include names, as the parser finds it.
std::optional<fs::path> included_file(const Workspace& workspace, const Analysis& analysis,
                                      const std::string& wanted) {
  std::vector<fs::path> folders{fs::path(analysis.file).parent_path()};
  const auto& more = workspace.options().include_folders;
  folders.insert(folders.end(), more.begin(), more.end());
  for (const fs::path& folder : folders) {
    const fs::path path = (folder / wanted).lexically_normal();
    if (workspace.is_open(path) || workspace.read(path)) return path;
  }
  for (const fs::path& folder : more)
    if (const auto found = scene::files_below(folder, wanted); found.size() == 1)
      return folder / found[0];
  return std::nullopt;
}

}  // namespace

std::vector<Link> links_of(const Workspace& workspace, const Analysis& analysis) {
  std::vector<Link> links;
  const auto& tokens = analysis.tokens;
  const fs::path folder = fs::path(analysis.file).parent_path();
  for (size_t i = 0; i < tokens.size(); ++i) {
    const scene::Token& token = tokens[i];
    if (token.kind != scene::TokenKind::text || token.faulty || token.text.size() < 3) continue;
    const std::string name = scene::unquote(token.text);
    std::optional<fs::path> target;
    std::error_code failed;
    if (i > 0 && tokens[i - 1].is_name("include"))
      target = included_file(workspace, analysis, name);
    else if (name.find('.') != std::string::npos && fs::is_regular_file(folder / name, failed))
      target = (folder / name).lexically_normal();
    if (target)
      links.push_back({range_between(analysis.file, {token.line, token.column + 1},
                                     {token.end_line(), token.end_column() - 1}),
                       *target});
  }
  return links;
}

}  // namespace vug::language
