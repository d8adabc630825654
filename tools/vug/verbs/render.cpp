// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "progress_bar.h"
#include "scene_at_frame.h"
#include "scene_options.h"
#include "setting_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/dependencies.h>
#include <vug/loading/placement/check.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/stereo_views.h>

#include <cmath>
#include <cstdio>
#include <memory>

namespace vug::cli {
namespace {

struct Options {
  SceneOptions scene;
  WorkOptions work;
  std::string output;
  std::string products;
  std::string tile, samples, frames, eye;
  std::string part, checkpoint, preview, guiding;
  std::string ocio;
  bool anyway = false;
  SettingOptions settings;
  picture::PictureOptions picture;
  picture::RenderOptions render;
};

/// The choice of the picture from the texts of the options.
picture::PictureOptions parse_picture(const Options& options) {
  picture::PictureOptions picture = options.picture;
  picture.settings = options.settings.values();
  picture.config = options.ocio;
  if (options.ocio.empty()) picture.config = image::environment_config();
  if (!picture.seed) picture.seed = options.scene.seed;
  if (!options.eye.empty()) picture.eye = options.eye == "left" ? -1 : 1;
  return picture;
}

constexpr const char* kOutputs =
    "write -o and an .exr for a picture, --part and a file for a partial render, or --guiding and "
    "a file to learn only";

/// True if the guiding file is the only product.
bool learns_only(const Options& options) { return options.output.empty() && options.part.empty(); }

void parse(Options& options) {
  options.picture = parse_picture(options);
  picture::RenderOptions& render = options.render;
  if (!options.tile.empty()) {
    const auto tile = parse_numbers(options.tile, "N/N", "tile", "write --tile 1/4 to --tile 4/4");
    render.slice.band = tile[0] - 1, render.slice.bands = tile[1];
  }
  if (!options.samples.empty()) {
    const auto range = parse_numbers(options.samples, "N..N", "range of samples",
                                     "write --samples 0..64, and --samples 64..128 for the next");
    render.slice.begin = static_cast<uint32_t>(range[0]);
    render.slice.end = static_cast<uint32_t>(range[1]);
    if (range[0] >= range[1])
      throw Error(ErrorCode::bad_input,
                  fmt::format("invalid range of samples '{}': it is empty", options.samples), {},
                  "write --samples 0..64; the second number is exclusive");
  }
  render.part = options.part, render.checkpoint = options.checkpoint;
  render.preview = options.preview, render.guiding = options.guiding;
  if (!options.output.empty() && !options.part.empty())
    throw Error(ErrorCode::bad_input, "-o and --part exclude each other", {}, kOutputs);
  if (options.output.empty() && options.part.empty() && options.guiding.empty())
    throw Error(ErrorCode::bad_input, "no output file given", {}, kOutputs);
  if (!options.output.empty())
    require_extension(options.output, ".exr", "the picture is an EXR; a PNG is written next to it");
  if (!options.preview.empty()) require_extension(options.preview, ".png", "");
}

std::string time_text(double seconds) {
  if (seconds < 90) return fmt::format("about {:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("about {:.0f} min", seconds / 60);
  return fmt::format("about {:.1f} h", seconds / 3600);
}

/// Prints the estimate of the rendering and of the whole picture, on which `before` seconds have
/// been spent.
void print_estimate(double before, double seconds, double bytes) {
  if (seconds < 5 && bytes < 0x1p30) return;  // too short to report
  clear_progress_bar();
  fmt::print(stderr, "rendering takes {} and {}, after {:.0f} s of preparation: {} in all\n",
             time_text(seconds), bytes_text(bytes), before, time_text(before + seconds));
}

/// Renders and writes one picture of the loaded scene.
void render_one(const Options& options, building::Builder& builder,
                const picture::PicturePlan& plan, double start) {
  if (learns_only(options)) {
    picture::learn_light(builder, plan, options.guiding);
    fmt::print("{}\n", options.guiding);
    return;
  }
  picture::RenderOptions render = options.render;
  if (!options.work.quiet)
    render.estimate = [&](double seconds, double bytes) {
      print_estimate(stage_times().total_seconds() - start, seconds, bytes);
    };
  const std::vector<picture::RenderResult> rendered = picture::render_views(builder, plan, render);
  const std::vector<picture::PictureView> views = picture::picture_views(rendered);
  if (views.empty()) {
    fmt::print("{}\n", options.part);
  } else {
    picture::warn_about_exposure(builder, rendered.front());
    for (const auto& path : picture::write_picture(options.output, views, builder.progress()))
      fmt::print("{}\n", path.string());
  }
  if (!options.products.empty())
    for (const auto& path : delivery::write_products(builder, options.products))
      fmt::print("{}\n", path.string());
  std::fflush(stdout);
  picture::remove_checkpoint(options.render);
}

void require_outputs(const Options& options, const loading::Loaded& loaded,
                     const picture::PicturePlan& plan) {
  std::vector<std::filesystem::path> outputs;
  for (const std::string& path :
       {options.output, options.part, options.checkpoint, options.guiding})
    if (!path.empty()) outputs.emplace_back(path);
  if (!options.output.empty()) outputs.push_back(picture::png_path(options.output));
  // The preview may have the same name as the final picture.
  if (!options.preview.empty() &&
      (options.output.empty() || options.preview != picture::png_path(options.output)))
    outputs.emplace_back(options.preview);
  if (!options.output.empty() && plan.render.settings.deep)
    outputs.push_back(picture::deep_path(options.output));
  if (!options.products.empty())
    for (auto& path : delivery::product_paths(loaded.shot, options.products))
      outputs.push_back(std::move(path));
  vug::require_outputs(outputs, loading::file_dependencies(loaded));
}

/// Refuses a scene whose camera or lights are in rock, whose props float or whose voids are filled.
void require_placement(const Options& options, const loading::Loaded& loaded,
                       const picture::PicturePlan& plan, loading::Accuracy accuracy) {
  if (options.anyway) return;
  Diagnostics mistakes;
  loading::check_placement(loaded, {picture::camera_name(loaded.shot, plan.render), accuracy},
                           mistakes);
  if (!mistakes.has_errors()) return;
  clear_progress_bar();
  fmt::print(stderr, "{}the render was not started; --anyway renders the scene as it is\n",
             loaded.report(mistakes));
  throw ExitRequest{kUnusable};
}

/// The options with the frame number inserted into file names that contain a placeholder.
Options with_frame_number(const Options& options, int frame) {
  Options out = options;
  for (std::string* path :
       {&out.output, &out.part, &out.checkpoint, &out.products, &out.preview, &out.guiding})
    if (picture::has_frame_number(*path)) *path = picture::frame_path(*path, frame).string();
  out.render.part = out.part, out.render.checkpoint = out.checkpoint;
  out.render.preview = out.preview, out.render.guiding = out.guiding;
  return out;
}

/// The options for one picture of a sequence.
Options options_at_frame(const Options& options, int frame) {
  for (const std::string* path :
       {&options.output, &options.part, &options.checkpoint, &options.products, &options.guiding})
    if (!path->empty())
      picture::frame_path(*path, frame);  // throws for a name without a placeholder
  Options out = with_frame_number(options, frame);
  if (out.checkpoint.empty()) out.render.resume = false;  // only complete frames are kept
  return out;
}

/// `require_placement` with exact values, as stages.
void check_placement(const Options& options, SceneAtFrame& scene, const picture::PicturePlan& plan,
                     Progress& progress) {
  if (options.anyway) return;
  scene.builder.compute_deferred();
  run_stage(progress, "checking the placement",
            [&] { require_placement(options, scene.loaded, plan, loading::Accuracy::exact); });
}

int run_frames(const Options& options, const loading::SceneSource& source, Progress& progress) {
  const std::vector<int> frames = picture::parse_frames(options.frames);
  for (const int frame : frames) options_at_frame(options, frame);  // check names before any work
  for (const int frame : frames) {  // and the animation before the first picture
    if (options.anyway) break;
    const loading::Loaded loaded = source.at(frame);
    if (!loaded.usable()) break;  // reported at this frame
    require_placement(options, loaded, picture::plan_picture(loaded.shot, options.picture),
                      loading::Accuracy::bounds);
  }
  std::unique_ptr<SceneAtFrame> now;
  double seconds = 0;
  size_t rendered = 0, skipped = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    const Options one = options_at_frame(options, frames[i]);
    const double start = stage_times().total_seconds();
    auto next = std::make_unique<SceneAtFrame>(options.scene.load(source, frames[i]), options.work,
                                               progress);
    if (now) next->builder.reuse_from(std::move(now->builder));
    now = std::move(next);
    const picture::PicturePlan plan = picture::plan_picture(now->loaded.shot, one.picture);
    if (options.render.resume && !one.output.empty() &&
        picture::is_finished(one.output, now->loaded.shot, plan)) {
      picture::remove_checkpoint(one.render);
      ++skipped;
      continue;
    }
    require_outputs(one, now->loaded, plan);
    check_placement(options, *now, plan, progress);
    if (!options.work.quiet) {
      clear_progress_bar();
      fmt::print(stderr, "frame {}, {} of {}", frames[i], i + 1, frames.size());
      if (rendered > 0)
        fmt::print(stderr, ", {} left",
                   time_text(seconds / static_cast<double>(rendered) *
                             static_cast<double>(frames.size() - i)));
      fmt::print(stderr, "\n");
    }
    try {
      render_one(one, now->builder, plan, start);
    } catch (Error& error) {
      throw error.within(fmt::format("rendering frame {}", frames[i]));
    }
    seconds += stage_times().total_seconds() - start;
    ++rendered;
  }
  if (skipped > 0 && !options.work.quiet)
    fmt::print(stderr, "{} {} finished already\n", skipped,
               skipped == 1 ? "frame was" : "frames were");
  options.work.summarise(now->builder);
  return kDone;
}

int run(Options options) {
  parse(options);
  Progress& progress = terminal_progress(options.work.bar_mode());
  const loading::SceneSource source = options.scene.source();
  options.picture.source = &source;
  if (!options.frames.empty()) return run_frames(options, source, progress);
  if (const auto& frame = options.scene.frame;
      frame && *frame == std::floor(*frame) && std::fabs(*frame) < 1e9)
    options = with_frame_number(options, static_cast<int>(*frame));
  SceneAtFrame scene(options.scene.load(source, options.scene.frame.value_or(1)), options.work,
                     progress);
  const picture::PicturePlan plan = picture::plan_picture(scene.loaded.shot, options.picture);
  require_outputs(options, scene.loaded, plan);
  check_placement(options, scene, plan, progress);
  render_one(options, scene.builder, plan, 0);
  options.work.summarise(scene.builder);
  return kDone;
}

}  // namespace

Verb render_verb() {
  return {
      "render", "Renders a picture: an EXR with AOVs, and a PNG next to it.", [](CLI::App& app) {
        auto options = std::make_shared<Options>();
        options->scene.add_to(app, &options->work);
        auto& render = options->render;
        auto& picture = options->picture;
        app.add_option("-o,--output", options->output, "Output file, an .exr");
        app.add_option("--products", options->products,
                       "Folder for the products of `vug build`, which are written as well");
        app.add_option("--sample-seed", picture.seed,
                       "Seed of the samples; --seed changes the scene itself")
            ->check(seed_number());
        app.add_option("--camera", picture.camera, "Name of the camera");
        app.add_option("--render", picture.render, "Name of the render block");
        app.add_option("--eye", options->eye,
                       "Render only one view of a stereo camera: left or right")
            ->check(one_of({"left", "right"}));
        app.add_flag("--anyway", options->anyway,
                     "Render even if the camera or a light is in rock, a prop floats, or a void is "
                     "filled");
        app.add_option("--ocio", options->ocio,
                       "OpenColorIO configuration for the PNG; default $OCIO");
        options->settings.add_to(app);
        app.add_option("--preview", options->preview,
                       "PNG of the unfinished picture, which is updated during rendering");
        auto* checkpoint = app.add_option("--checkpoint", options->checkpoint,
                                          "Checkpoint file, from which --resume continues");
        app.add_option("--checkpoint-every", render.checkpoint_every,
                       "Interval between checkpoints in seconds")
            ->transform(number_in(Dimension::time, 0, 1e6))
            ->needs(checkpoint);
        app.add_option(
               "--frames", options->frames,
               "Frames to render, A..B or A..BxSTEP; the file name contains #### as placeholder")
            ->excludes("--frame");
        app.add_flag("--resume", render.resume,
                     "Continue from the checkpoint if it exists; with --frames, skip finished "
                     "frames");
        app.add_option("--part", options->part,
                       "Write a partial render for `vug merge` instead of a picture");
        app.add_option("--guiding", options->guiding,
                       "File of the learned light for all parts: read if it exists, else written; "
                       "without -o and --part, nothing is rendered");
        app.add_option("--tile", options->tile, "Band of the picture for --part, I/N: band I of N");
        app.add_option("--samples", options->samples,
                       "Samples of each pixel for --part, A..B: samples A to B-1");
        options->work.add_to(app);
        return [options] {
          return with_threads(options->work.threads, [&] { return run(*options); });
        };
      }};
}

}  // namespace vug::cli
