// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/grammar_output.h>
#include <vug/loading/data_folders.h>
#include <vug/loading/resolver.h>
#include <vug/scene/check.h>
#include <vug/scene/parser.h>
#include <vug/session/facade_model.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace vug::session {

namespace fs = std::filesystem;

namespace {

/// Maximum voxel size in metres at which walls resolve the frames of panes.
constexpr double kFramedVoxel = 0.05;

}  // namespace

fs::path find_grammar_file(const fs::path& folder, const std::string& file) {
  std::vector<fs::path> folders;
  if (!folder.empty()) folders.push_back(folder);
  for (const fs::path& data : loading::data_folders()) {
    folders.push_back(data);
    folders.push_back(data / "facades");
  }
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::path& each : folders) {
    // Also valid for a folder that does not exist yet.
    const fs::path there = (each / file).lexically_normal();
    if (fs::is_regular_file(there, ignored)) return there;
    for (const fs::directory_entry& entry : fs::directory_iterator(each, ignored))
      if (entry.path().extension() == ".vug") names.push_back(entry.path().filename().string());
  }
  throw Error(ErrorCode::bad_input, fmt::format("there is no grammar '{}': no such file", file), {},
              did_you_mean(file, names,
                           "name a file with its folder, or one of data/facades, as ripperda.vug"));
}

modeller::StyleLoader facade_style_loader(const fs::path& folder) {
  return [folder](const std::string& file, const std::string& facade) {
    Diagnostics diagnostics;
    scene::ParseOptions options;
    options.include_folders = loading::data_folders();
    scene::Document document =
        scene::parse_file(find_grammar_file(folder, file), diagnostics, options);
    for (const Diagnostic& one : diagnostics.all())
      if (one.severity == Severity::error)
        throw Error(ErrorCode::bad_input, one.message, one.where, one.hint);
    return modeller::Style::make(std::move(document), facade,
                                 std::make_shared<loading::Resolver>());
  };
}

std::string relative_path_from(const fs::path& folder, const fs::path& file) {
  return fs::absolute(file)
      .lexically_normal()
      .lexically_relative(fs::absolute(folder).lexically_normal())
      .generic_string();
}

modeller::SessionHeader moved_header(modeller::SessionHeader header, const fs::path& from,
                                     const fs::path& to) {
  if (from == to) return header;
  if (fs::exists(from / header.grammar))
    header.grammar = relative_path_from(to, from / header.grammar);
  if (header.photo) header.photo->file = relative_path_from(to, from / header.photo->file);
  return header;
}

std::string valid_grammar_name(const std::string& text) {
  static const std::set<std::string> taken = {"main", "even", "voxel", "stone", "panes"};
  std::string out;
  for (const char c : text) out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  if (out.empty() || !std::isalpha(static_cast<unsigned char>(out[0])) || taken.count(out) ||
      !scene::may_name(out))
    out = "facade_" + out;
  return out;
}

std::string pane_voxel(const std::string& voxel) {
  return fmt::format("min({0}, clamp({0} / 4, 1cm, 3cm))", voxel);
}

std::string carving_scene(const facade::Tree& tree, const CarvingOptions& options) {
  const std::string& name = options.name.empty() ? tree.name : options.name;
  const std::string voxel = fmt::format("{}m", options.voxel);
  std::string out = facade::grammar_text(tree, {.name = name, .thickness = options.thickness});
  out += fmt::format("\nvolume stone = level_set({}, voxel: {})\n", name, voxel);
  const bool filled =
      options.voxel <= kFramedVoxel &&
      std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const facade::Node& node) {
        return node.element &&
               !node.element->solids(node.rect.width, node.rect.height).fill.empty();
      });
  if (filled)
    out +=
        fmt::format("volume panes = level_set(infill({}), voxel: {})\n", name, pane_voxel(voxel));
  return out;
}

}  // namespace vug::session
