#include <vug/facade/carve.h>
#include <vug/facade/grammar_output.h>
#include <vug/field/affine.h>
#include <vug/scene/parser.h>
#include <vug/session/data_folders.h>
#include <vug/session/facade_model.h>
#include <vug/session/resolver.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::session {

namespace fs = std::filesystem;

namespace {

/// Larger voxels cannot hold sheets of glass, and walls of larger ones no frames of them; metres.
constexpr double kPaneVoxel = 0.01, kFramedVoxel = 0.05;

}  // namespace

fs::path find_grammar(const fs::path& folder, const std::string& file) {
  std::vector<fs::path> folders;
  if (!folder.empty()) folders.push_back(folder);
  for (const fs::path& data : data_folders()) {
    folders.push_back(data);
    folders.push_back(data / "facades");
  }
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::path& each : folders) {
    // Also from a folder that is yet to be made.
    const fs::path there = (each / file).lexically_normal();
    if (fs::is_regular_file(there, ignored)) return there;
    for (const fs::directory_entry& entry : fs::directory_iterator(each, ignored))
      if (entry.path().extension() == ".vug") names.push_back(entry.path().filename().string());
  }
  const std::string near = nearest_name(file, names);
  throw Error(ErrorCode::bad_input, fmt::format("there is no grammar '{}': no such file", file), {},
              near.empty() ? "name a file with its folder, or one of data/facades, as ripperda.vug"
                           : fmt::format("did you mean '{}'?", near));
}

modeller::StyleLoader facade_styles(const fs::path& folder) {
  return [folder](const std::string& file, const std::string& facade) {
    Diagnostics diagnostics;
    scene::ParseOptions options;
    options.include_folders = data_folders();
    scene::Document document = scene::parse_file(find_grammar(folder, file), diagnostics, options);
    for (const Diagnostic& one : diagnostics.all())
      if (one.severity == Severity::error)
        throw Error(ErrorCode::bad_input, one.message, one.where, one.hint);
    return modeller::Style::make(std::move(document), facade, std::make_shared<Resolver>());
  };
}

Shot facade_shot(const facade::Tree& tree, const FacadeCarving& options) {
  const auto shared = std::make_shared<const facade::Tree>(tree);
  const facade::Frame frame;
  Shot out;
  out.name = tree.name;
  const auto add = [&](const std::string& name, const field::Field& field, double voxel) {
    VolumePlan plan;
    plan.name = options.prefix + name;
    plan.field = field;
    plan.voxel = voxel;
    out.volumes.push_back(std::make_shared<const VolumePlan>(std::move(plan)));
  };
  add("stone", facade::wall(shared, frame, options.thickness), options.voxel);
  const bool filled =
      options.voxel <= kFramedVoxel &&
      std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const facade::Node& node) {
        return node.element &&
               !node.element->solids(node.rect.width, node.rect.height).fill.empty();
      });
  if (filled)
    add("panes", field::transformed(facade::carve(tree).fill, frame.transform(tree.width)),
        std::min(kPaneVoxel, options.voxel));
  return out;
}

Loaded load_carving(const facade::Tree& tree, const FacadeCarving& options, std::string scene,
                    const std::string& file) {
  Shot shot = facade_shot(tree, options);
  if (scene.empty()) {
    scene = facade::grammar_text(tree, {.name = tree.name, .thickness = options.thickness});
    for (const auto& volume : shot.volumes)
      scene += fmt::format(
          "\nvolume {} = level_set({}, voxel: {}m)\n", volume->name,
          volume == shot.volumes.front() ? tree.name : fmt::format("infill({})", tree.name),
          volume->voxel);
  }
  Loaded out = load_text(std::move(scene), file);
  if (!out.usable()) return out;
  shot.recipe = out.shot.recipe, shot.seed = out.shot.seed;
  out.shot = std::move(shot);
  return out;
}

}  // namespace vug::session
