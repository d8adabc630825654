// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/loading/data_folders.h>
#include <vug/session/archetypes.h>

namespace vug::cli {
namespace {

struct NewOptions {
  std::string file, like;
};

void list_archetypes() {
  for (const session::Archetype& each : session::archetypes(loading::data_folders())) {
    fmt::print("{:<16} {}\n", each.name, each.doc);
    if (!each.thumbnail.empty()) fmt::print("{:<16} {}\n", "", each.thumbnail.string());
  }
  fmt::print("\n'vug new my_cave --like NAME' writes a scene that renders one of them.\n");
}

/// The path with the extension of scenes.
std::filesystem::path scene_path(const std::string& file) {
  std::filesystem::path path = file;
  if (path.extension() != ".vug") path += ".vug";
  return path;
}

int run_new(const NewOptions& options) {
  if (options.file.empty() && options.like.empty()) {
    list_archetypes();
    return kDone;
  }
  if (options.file.empty() || options.like.empty())
    throw Error(ErrorCode::bad_input, "a new scene needs a name and an archetype", {},
                "write vug new my_cave --like show_cave; 'vug new' lists the archetypes");
  const std::filesystem::path file = scene_path(options.file);
  const session::Archetype archetype =
      session::find_archetype(loading::data_folders(), options.like);
  if (std::filesystem::exists(file))
    throw Error(ErrorCode::bad_input, fmt::format("'{}' exists already", file.string()), {},
                "choose another name, or remove the file first");
  require_outputs({file}, {});
  const std::string stem = (file.parent_path() / file.stem()).string();
  write_text(file, session::new_scene(archetype, stem));
  fmt::print("{}\n", file.string());
  fmt::print(stderr, "render it with: vug render '{0}' -o '{1}.exr'\n", file.string(), stem);
  return kDone;
}

}  // namespace

Verb new_verb() {
  return {"new", "Writes a scene that renders an archetype of a cave, or lists the archetypes.",
          [](CLI::App& app) {
            auto options = std::make_shared<NewOptions>();
            app.add_option("file", options->file, "The new scene, such as my_cave.vug");
            app.add_option("--like", options->like, "Name of the archetype, such as show_cave");
            return [options] { return run_new(*options); };
          }};
}

}  // namespace vug::cli
