// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/delivery/assembly.h>
#include <vug/loading/data_folders.h>
#include <vug/loading/dependencies.h>
#include <vug/session/preview.h>

namespace vug::cli {
namespace {

struct PreviewOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string output, picture, mesh;
  bool render = false;
  int max_triangles = 300000;
};

/// The page template: preview.html of the data folders, or that of the build.
std::filesystem::path page_file() {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& folder : loading::data_folders())
    files.push_back(folder / "preview.html");
  files.emplace_back(VUG_BUILT_PAGE);
  for (const std::filesystem::path& file : files)
    if (unreadable_reason(file).empty()) return file;
  throw Error(ErrorCode::bad_input,
              fmt::format("the preview page '{}' has not been built", VUG_BUILT_PAGE), {},
              "configure and build vug again, with npm installed and access to its registry; the "
              "output of the build contains npm's own message");
}

int run_preview(PreviewOptions options) {
  const std::filesystem::path page = page_file();
  if (options.output.empty())
    options.output = std::filesystem::path(options.scene.scene).stem().string() + ".html";
  require_extension(options.output, ".html", "the page is an .html file");
  const loading::Loaded loaded = options.scene.load();
  const shot::Shot shot = delivery::with_meshes(loaded.shot);
  std::vector<std::filesystem::path> inputs = loading::file_dependencies(loaded);
  inputs.push_back(page);
  if (!options.picture.empty()) inputs.emplace_back(options.picture);
  require_outputs({options.output}, inputs);

  session::PreviewOptions what;
  what.page = read_text(page);
  what.picture = options.picture, what.render = options.render, what.mesh = options.mesh;
  what.max_triangles = static_cast<size_t>(options.max_triangles);
  building::Builder builder(shot, options.work.build_options(loaded),
                            terminal_progress(options.work.bar_mode()));
  const session::Preview made = session::make_preview(builder, loaded, what);
  write_text(options.output, made.page);
  fmt::print("{}\n", options.output);
  clear_progress_bar();
  for (const std::string& each : made.unsupported) fmt::print(stderr, "omitted: {}\n", each);
  if (options.work.quiet) return kDone;
  if (made.triangles < made.whole)
    fmt::print(stderr, "decimated to {} of {} triangles\n", made.triangles, made.whole);
  options.work.summarise(builder);
  return kDone;
}

}  // namespace

Verb preview_verb() {
  return {"preview", "Writes a self-contained web page with the model, picture, tree and metrics.",
          [](CLI::App& app) {
            auto options = std::make_shared<PreviewOptions>();
            options->scene.add_to(app, &options->work);
            app.add_option("-o,--output", options->output,
                           "Output file, an .html; default: the scene's name with this extension");
            auto* picture =
                app.add_option("--picture", options->picture, "Picture to show, a .png or .jpg");
            app.add_flag("--render", options->render, "Render a small picture to show")
                ->excludes(picture);
            app.add_option("--max-triangles", options->max_triangles,
                           "Number of triangles to which the model is decimated; default 300000")
                ->check(integer_in(100, 100000000));
            app.add_option("--mesh", options->mesh,
                           "Mesh whose metrics are shown; default the largest");
            options->work.add_to(app);
            return [options] {
              return with_threads(options->work.threads, [&] { return run_preview(*options); });
            };
          }};
}

}  // namespace vug::cli
