// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "progress_bar.h"
#include "scene_at_frame.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/stereo_views.h>

#include <charconv>
#include <chrono>
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
  std::string size, tile, samples, crop, frames, eye;
  std::string part, checkpoint, preview;
  std::string ocio, working_space;
  picture::RenderOptions render;
};

std::vector<std::string> space_names() {
  std::vector<std::string> names;
  for (const image::WorkingSpaceInfo& each : image::working_spaces()) names.push_back(each.name);
  return names;
}

/// Parses a text of the form `pattern`, in which each 'N' stands for a non-negative integer.
std::vector<int> parse_numbers(const std::string& text, const std::string& pattern,
                               const std::string& what, const std::string& hint) {
  std::vector<int> numbers;
  const char *at = text.data(), *end = text.data() + text.size();
  bool good = true;
  for (const char c : pattern) {
    if (c != 'N') {
      good = good && at != end && *at == c;
      if (good) ++at;
      continue;
    }
    const auto read = std::from_chars(at, end, numbers.emplace_back());
    good = good && read.ec == std::errc() && numbers.back() >= 0;
    at = read.ptr;
  }
  if (!good || at != end)
    throw Error(ErrorCode::bad_input, fmt::format("invalid {} '{}'", what, text), {}, hint);
  return numbers;
}

void parse(Options& options) {
  picture::RenderOptions& render = options.render;
  if (!options.size.empty()) {
    const auto size = parse_numbers(options.size, "NxN", "size", "write --size 1920x1080");
    render.picture.size = Vec2i(size[0], size[1]);
    if (size[0] < 1 || size[1] < 1)
      throw Error(
          ErrorCode::bad_input,
          fmt::format("invalid size '{}': width and height must be at least 1", options.size), {},
          "write --size 1920x1080");
  }
  if (!options.crop.empty()) {
    auto& crop = render.picture.crop;
    crop = parse_numbers(options.crop, "N,N,N,N", "crop", "write --crop left,top,right,bottom");
    if (crop[0] >= crop[2] || crop[1] >= crop[3])
      throw Error(ErrorCode::bad_input,
                  fmt::format("invalid crop '{}': it contains no pixels", options.crop), {},
                  "write --crop left,top,right,bottom; right and bottom are exclusive");
  }
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
  render.picture.config = options.ocio;
  if (options.ocio.empty()) render.picture.config = image::environment_config();
  for (const image::WorkingSpaceInfo& each : image::working_spaces())
    if (each.name == options.working_space) render.picture.working_space = each.space;
  if (!render.picture.seed) render.picture.seed = options.scene.seed;
  render.part = options.part, render.checkpoint = options.checkpoint;
  render.preview = options.preview;
  if (!options.eye.empty()) render.picture.eye = options.eye == "left" ? -1 : 1;
  if (options.output.empty() == options.part.empty())
    throw Error(ErrorCode::bad_input,
                options.part.empty() ? "no output file given" : "-o and --part exclude each other",
                {},
                "write -o and an .exr for a picture, or --part and a file for a partial render");
  if (!options.output.empty())
    require_extension(options.output, ".exr", "the picture is an EXR; a PNG is written next to it");
  if (!options.preview.empty()) require_extension(options.preview, ".png", "");
}

std::string time_text(double seconds) {
  if (seconds < 90) return fmt::format("about {:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("about {:.0f} min", seconds / 60);
  return fmt::format("about {:.1f} h", seconds / 3600);
}

/// Renders and writes one picture of the loaded scene.
void render_one(const Options& options, building::Builder& builder) {
  const std::vector<picture::RenderResult> rendered =
      picture::render_views(builder, options.render);
  const std::vector<picture::PictureView> views = picture::picture_views(rendered);
  if (views.empty()) {
    fmt::print("{}\n", options.part);
  } else {
    picture::warn_about_exposure(builder, rendered.front());
    for (const auto& path : picture::write_picture(options.output, views))
      fmt::print("{}\n", path.string());
  }
  if (!options.products.empty())
    for (const auto& path : delivery::write_products(builder, options.products))
      fmt::print("{}\n", path.string());
  std::fflush(stdout);
  picture::remove_checkpoint(options.render);
}

void require_outputs(const Options& options, const loading::Loaded& loaded) {
  std::vector<std::filesystem::path> outputs;
  for (const std::string& path : {options.output, options.part, options.checkpoint})
    if (!path.empty()) outputs.emplace_back(path);
  if (!options.output.empty()) outputs.push_back(picture::png_path(options.output));
  // The preview may have the same name as the final picture.
  if (!options.preview.empty() &&
      (options.output.empty() || options.preview != picture::png_path(options.output)))
    outputs.emplace_back(options.preview);
  if (!options.output.empty() && picture::render_plan(loaded.shot, options.render.picture).deep)
    outputs.push_back(picture::deep_path(options.output));
  if (!options.products.empty())
    for (auto& path : delivery::product_paths(loaded.shot, options.products))
      outputs.push_back(std::move(path));
  vug::require_outputs(outputs, loading::file_dependencies(loaded));
}

/// The options with the frame number inserted into file names that contain a placeholder.
Options with_frame_number(const Options& options, int frame) {
  Options out = options;
  for (std::string* path : {&out.output, &out.part, &out.checkpoint, &out.products, &out.preview})
    if (picture::has_frame_number(*path)) *path = picture::frame_path(*path, frame).string();
  out.render.part = out.part, out.render.checkpoint = out.checkpoint;
  out.render.preview = out.preview;
  return out;
}

/// The options for one picture of a sequence.
Options options_at_frame(const Options& options, int frame) {
  for (const std::string* path :
       {&options.output, &options.part, &options.checkpoint, &options.products})
    if (!path->empty())
      picture::frame_path(*path, frame);  // throws for a name without a placeholder
  Options out = with_frame_number(options, frame);
  if (out.checkpoint.empty()) out.render.resume = false;  // only complete frames are kept
  return out;
}

int run_frames(const Options& options, loading::StaticCache& static_cache, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  const std::vector<int> frames = picture::parse_frames(options.frames);
  for (const int frame : frames) options_at_frame(options, frame);  // check names before any work
  std::unique_ptr<SceneAtFrame> now;
  double seconds = 0;
  size_t rendered = 0, skipped = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    const Options one = options_at_frame(options, frames[i]);
    auto next = std::make_unique<SceneAtFrame>(options.scene.load(frames[i], static_cache),
                                               options.work, progress);
    if (now) next->builder.reuse_from(std::move(now->builder));
    now = std::move(next);
    if (options.render.resume && one.part.empty() &&
        picture::is_finished(one.output, now->loaded.shot, one.render.picture)) {
      picture::remove_checkpoint(one.render);
      ++skipped;
      continue;
    }
    require_outputs(one, now->loaded);
    if (!options.work.quiet) {
      clear_progress_bar();
      fmt::print(stderr, "frame {}, {} of {}", frames[i], i + 1, frames.size());
      if (rendered > 0)
        fmt::print(stderr, ", {} left",
                   time_text(seconds / static_cast<double>(rendered) *
                             static_cast<double>(frames.size() - i)));
      fmt::print(stderr, "\n");
    }
    const Clock::time_point start = Clock::now();
    try {
      render_one(one, now->builder);
    } catch (Error& error) {
      throw error.within(fmt::format("rendering frame {}", frames[i]));
    }
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
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
  if (!options.work.quiet)
    options.render.estimate = [](double seconds, double bytes) {
      if (seconds < 5 && bytes < 0x1p30) return;  // too short to report
      clear_progress_bar();
      fmt::print(stderr, "rendering takes {} and {}\n", time_text(seconds), bytes_text(bytes));
    };
  const ThreadLimit threads(options.work.threads);
  Progress& progress = terminal_progress(options.work.bar_mode());
  loading::StaticCache static_cache;
  options.render.picture.shot_at_frame = options.scene.shot_at_frame(static_cache);
  if (!options.frames.empty()) return run_frames(options, static_cache, progress);
  if (const auto& frame = options.scene.frame;
      frame && *frame == std::floor(*frame) && std::fabs(*frame) < 1e9)
    options = with_frame_number(options, static_cast<int>(*frame));
  SceneAtFrame scene(options.scene.load(options.scene.frame.value_or(1), static_cache),
                     options.work, progress);
  require_outputs(options, scene.loaded);
  render_one(options, scene.builder);
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
        auto& picture = render.picture;
        app.add_option("-o,--output", options->output, "Output file, an .exr");
        app.add_option("--products", options->products,
                       "Folder for the products of `vug build`, which are written as well");
        app.add_option("--sample-seed", options->render.picture.seed,
                       "Seed of the samples; --seed changes the scene itself")
            ->check(seed_number());
        app.add_option("--spp", picture.spp, "Samples per pixel")->check(integer_in(1, 1 << 20));
        app.add_option("--size", options->size, "Size of the picture, WIDTHxHEIGHT in pixels");
        app.add_option(
            "--crop", options->crop,
            "Crop window, LEFT,TOP,RIGHT,BOTTOM in pixels; right and bottom are exclusive");
        app.add_option("--camera", picture.camera, "Name of the camera");
        app.add_option("--render", picture.render, "Name of the render block");
        app.add_option("--eye", options->eye,
                       "Render only one view of a stereo camera: left or right")
            ->check(one_of({"left", "right"}));
        app.add_option("--layers", picture.layers, "Names of AOVs, or all")->delimiter(',');
        app.add_option(
               "--noise", picture.noise,
               "Adaptive sampling: stop a pixel once its relative error is below this, e.g. 5%")
            ->transform(number_in(Dimension::ratio, 0, 1));
        app.add_option("--exposure", picture.exposure, "Exposure of the PNG in stops")
            ->transform(number_in(Dimension::none, -30, 30));
        app.add_option("--view", picture.view,
                       "View transform of the PNG: filmic, standard, aces, or one of --ocio");
        app.add_option("--display", picture.display, "Display of --ocio, for the PNG");
        app.add_option("--ocio", options->ocio,
                       "OpenColorIO configuration for the PNG; default $OCIO");
        app.add_option("--working-space", options->working_space,
                       "Colour space in which light is computed")
            ->check(one_of(space_names()));
        app.add_flag("--float", picture.full_float, "32-bit colour channels in the EXR");
        app.add_flag("--denoise", picture.denoise,
                     "Denoise the PNG; the EXR gets an additional layer 'denoised'");
        app.add_flag("--deep", picture.deep,
                     "Also write a deep EXR, .deep.exr, with samples by depth");
        app.add_flag("--multi-part", picture.multi_part,
                     "Write each layer to a part of its own in the EXR");
        app.add_flag("--tiled", picture.tiled, "Store the EXR in tiles instead of scanlines");
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
        app.add_option("--tile", options->tile, "Band of the picture for --part, I/N: band I of N");
        app.add_option("--samples", options->samples,
                       "Samples of each pixel for --part, A..B: samples A to B-1");
        options->work.add_to(app);
        return [options] { return run(*options); };
      }};
}

}  // namespace vug::cli
