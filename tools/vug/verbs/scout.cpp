// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "scene_at_frame.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/image/io.h>
#include <vug/loading/data_folders.h>
#include <vug/loading/dependencies.h>
#include <vug/loading/scouted_cameras.h>
#include <vug/scout/contact_sheet.h>
#include <vug/scout/shot_text.h>

#include <cstdio>

namespace vug::cli {
namespace {

namespace fs = std::filesystem;

struct ScoutCommand {
  SceneOptions scene;
  WorkOptions work;
  int shots = 12;
  int spp = scout::SheetOptions{}.spp;
  std::string render, output;
  bool relight = false;
  double key_ratio = scout::ScoutOptions{}.key_ratio;
  std::optional<uint64_t> shot_seed;
};

/// The files that the command writes: the sheet, then the shots.
std::vector<fs::path> output_files(const fs::path& folder, size_t shots) {
  std::vector<fs::path> files = {folder / "sheet.png"};
  for (size_t i = 1; i <= shots; ++i) files.push_back(folder / loading::shot_file(i));
  return files;
}

void report_search(const scout::ScoutResult& found, const ScoutCommand& options) {
  if (options.work.quiet) return;
  clear_progress_bar();
  fmt::print(stderr, "{} of {} views pass all gates\n", found.passed, found.candidates);
  if (found.strictest)
    fmt::print(stderr, "most of the others fail because it is required that {}\n",
               scout::gate_text(*found.strictest));
}

int run_scout(const ScoutCommand& options) {
  Progress& progress = terminal_progress(options.work.bar_mode());
  const auto wanted = static_cast<size_t>(options.shots);
  SceneAtFrame scene(options.scene.load(), options.work, progress);
  const fs::path folder = options.output.empty() ? loading::shots_folder(options.scene.scene)
                                                 : fs::path(options.output);
  fs::create_directories(folder);
  require_outputs(output_files(folder, wanted), loading::file_dependencies(scene.loaded));
  picture::PictureOptions picture;
  picture.render = options.render;
  picture.config = image::environment_config();
  const picture::PicturePlan plan = picture::plan_picture(scene.loaded.shot, picture);
  const scout::Location location = scout::prepare_location(scene.builder, plan, options.relight);
  scout::ScoutOptions choice;
  choice.data_folders = loading::data_folders();
  choice.shots = wanted;
  choice.key_ratio = options.key_ratio;
  choice.seed = options.shot_seed.value_or(scene.loaded.shot.seed);
  const scout::ScoutResult found = scout::find_shots(location, choice, progress);
  report_search(found, options);
  scout::SheetOptions sheet;
  sheet.spp = options.spp;
  sheet.seed = choice.seed;
  std::vector<image::Image> pictures;
  const std::vector<fs::path> files = output_files(folder, found.shots.size());
  for (size_t i = 0; i < found.shots.size(); ++i) {
    const Progress::Product name(progress, fmt::format("shot {}", i + 1));
    const scout::ScoutedShot& shot = found.shots[i];
    pictures.push_back(scout::render_thumbnail(location, plan, shot.candidate.pose,
                                               scout::lights_of(shot.lamps, choice.data_folders),
                                               sheet, progress));
    write_text(files[i + 1],
               scout::shot_text(shot, i + 1, fs::path(options.scene.scene).filename().string()));
  }
  image::write_png(files[0], scout::contact_sheet(pictures), image::plain_view());
  for (const fs::path& file : files) fmt::print("{}\n", file.string());
  std::fflush(stdout);
  options.work.summarise(scene.builder);
  return kDone;
}

}  // namespace

Verb scout_verb() {
  return {
      "scout", "Finds shots of a scene: a contact sheet, and each shot as scene text.",
      [](CLI::App& app) {
        auto options = std::make_shared<ScoutCommand>();
        options->scene.unscouted = true;
        options->scene.add_to(app, &options->work);
        app.add_option("-o,--output", options->output,
                       "Folder of the sheet and the shots; default SCENE_shots next to the scene");
        app.add_option("--shots", options->shots, "Number of shots; default 12")
            ->check(integer_in(1, 99));
        app.add_option("--shot-seed", options->shot_seed,
                       "Seed of the search; default that of the scene")
            ->check(seed_number());
        app.add_option("--render", options->render,
                       "Render block whose lights, objects and view are used; default the first")
            ->type_name("NAME");
        app.add_flag("--relight", options->relight,
                     "Light the shots with lamps in place of the scene's own; the sky remains");
        app.add_option("--key-ratio", options->key_ratio,
                       "Light of the key on the subject relative to that of all other lamps; "
                       "default 8")
            ->transform(number_in(Dimension::none, 1, 1000));
        app.add_option("--spp", options->spp, "Samples per pixel of the sheet; default 8")
            ->check(integer_in(1, 4096));
        options->work.add_to(app);
        return [options] {
          return with_threads(options->work.threads, [&] { return run_scout(*options); });
        };
      }};
}

}  // namespace vug::cli
