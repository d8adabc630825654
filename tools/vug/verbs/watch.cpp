// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "progress_bar.h"
#include "render_pictures.h"
#include "watch/page_server.h"
#include "watch/watch_loop.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/base/pluralize.h>
#include <vug/picture/picture_file.h>

#include <cstdio>
#include <optional>

namespace vug::cli {
namespace {

struct Options {
  RenderOptions render;
  WatchOptions loop;
  int port = 0;
  bool no_page = false;
};

/// "2 meshes, 1 tree"; "nothing" without any.
std::string counts_text(const std::vector<std::pair<size_t, const char*>>& counts) {
  std::string text;
  for (const auto& [count, what] : counts)
    if (count > 0) text += (text.empty() ? "" : ", ") + pluralize(count, what);
  return text.empty() ? "nothing" : text;
}

std::string work_text(const watch::Work& work) {
  const building::ProductCounts& made = work.products;
  return fmt::format("built {}; kept {}; rendered {}",
                     counts_text({{made.level_sets, "level set"},
                                  {made.meshes, "mesh"},
                                  {made.surfaces, "surface"},
                                  {made.cell_layers, "cell layer"},
                                  {work.trees.built, "tree"},
                                  {work.parts.blocks.evaluated, "voxel block"},
                                  {work.parts.groups.evaluated, "polish group"}}),
                     counts_text({{work.declarations_kept, "declaration"},
                                  {work.trees.reused, "tree"},
                                  {work.parts.blocks.reused, "voxel block"},
                                  {work.parts.groups.reused, "polish group"}}),
                     counts_text({{work.samples, "sample"}}));
}

/// The files that `write` may write.
std::vector<std::filesystem::path> watched_outputs(const Options& options) {
  const std::filesystem::path output = options.render.output;
  if (output.extension() != ".exr") return {output};
  return {output, picture::png_path(output), picture::deep_path(output)};
}

/// Writes the complete picture, and its unfinished stages as a PNG.
void write(const Options& options, const WatchedPicture& picture) {
  const std::filesystem::path output = options.render.output;
  const bool exr = output.extension() == ".exr";
  if (!picture.complete)
    return picture::write_picture_file(exr ? picture::png_path(output) : output, picture.views);
  if (exr)
    picture::write_picture(output, picture.views);
  else
    picture::write_picture_file(output, picture.views);
}

int run_watch(Options options) {
  RenderOptions& render = options.render;
  if (render.output.empty())
    render.output = std::filesystem::path(render.scene.scene).stem().string() + ".png";
  if (const auto extension = std::filesystem::path(render.output).extension();
      extension != ".exr" && extension != ".png")
    throw Error(ErrorCode::bad_input, fmt::format("invalid picture name '{}'", render.output), {},
                "use the extension .exr for all layers with a PNG next to it, or .png");
  if (render.renders.size() > 1)
    throw Error(ErrorCode::bad_input, "'watch' renders one picture", {},
                "name one render block: --render NAME");
  watch::LiveOptions live;
  live.load = render.scene.load_options();
  live.picture = picture_options(render);
  if (!render.renders.empty()) live.picture.render = render.renders.front();
  live.build = [&](const loading::Loaded& loaded) { return render.work.build_options(loaded); };
  watch::LiveScene scene(render.scene.scene, std::move(live));

  LookRequests looks;
  std::optional<PageServer> page;
  if (!options.no_page && !options.loop.once) {
    page.emplace(options.port, std::filesystem::path(render.scene.scene).filename().string(),
                 [&](const watch::ViewRequest& look) { return looks.ask(look); });
    fmt::print(stderr, "page: {}\n", page->url());
  }
  Progress& stop = terminal_progress(render.work.bar_mode());
  const auto new_progress = [&] {
    return std::make_shared<Progress>([&](const std::string& stage, double fraction) {
      report_stage(render.work.bar_mode(), stage, fraction);
    });
  };
  bool checked = false;  // the outputs against the inputs, which ends the command
  WatchEvents events;
  events.problems = [&](const Diagnostics& problems, const std::string& report) {
    clear_progress_bar();
    if (page) page->show_problems(problems);
    fmt::print(stderr, "{}", report);
    if (!checked && scene.has_version()) {
      require_outputs(watched_outputs(options), scene.files());
      checked = true;
    }
  };
  events.picture = [&](const WatchedPicture& picture) {
    require_outputs(watched_outputs(options), scene.files());  // an edit may name other files
    write(options, picture);
    if (page)
      page->show_picture(read_text(picture::png_path(render.output)),
                         {picture.complete, picture.seconds, work_text(picture.work),
                          scene.camera_name(), scene.view()});
    clear_progress_bar();
    if (picture.complete) {
      fmt::print("{}\n", render.output);
      std::fflush(stdout);
    }
    if (!render.work.quiet)
      fmt::print(stderr, "{} after {:.2f} s: {}\n",
                 picture.complete ? "picture" : "unfinished picture", picture.seconds,
                 work_text(picture.work));
  };
  const bool sound = run_watch_loop(scene, options.loop, events, new_progress, looks, stop);
  return options.loop.once && !sound ? kUnusable : kDone;
}

}  // namespace

Verb watch_verb() {
  return {"watch", "Renders a scene again whenever one of its files is saved.", [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            add_picture_options(app, options->render);
            app.add_option("-o,--output", options->render.output,
                           "Picture, a .png, or an .exr with a PNG next to it; default: the "
                           "scene's name with .png");
            app.add_flag("--once", options->loop.once,
                         "End after the first picture; with exit code 2 if the scene has errors");
            app.add_flag("--polling", options->loop.polling,
                         "Look at the files ten times a second instead of waiting for events of "
                         "the system");
            auto* none = app.add_flag("--no-page", options->no_page, "Serve no page");
            app.add_option("--port", options->port,
                           "Port of the page, which only this machine can open; default: any "
                           "free one")
                ->check(integer_in(1, 65535))
                ->excludes(none);
            options->render.work.add_to(app);
            return [options] {
              return with_threads(options->render.work.threads,
                                  [&] { return run_watch(*options); });
            };
          }};
}

}  // namespace vug::cli
