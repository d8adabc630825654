// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "dark_scene.h"
#include "error_report.h"
#include "part_requests.h"
#include "progress_bar.h"
#include "render_pictures.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/exposure.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/stereo_views.h>
#include <vug/scout/preflight.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace vug::cli {
namespace {

constexpr const char* kOutputs =
    "write -o and an .exr for a picture, --part and a file for a partial render, or --guiding and "
    "a file to learn only";

/// Sets the range of samples from a text "A..B".
void set_samples(const std::string& text, render::RenderSlice& slice) {
  const auto range = parse_numbers(text, "N..N", "range of samples",
                                   "write --samples 0..64, and --samples 64..128 for the next");
  slice.begin = static_cast<uint32_t>(range[0]);
  slice.end = static_cast<uint32_t>(range[1]);
  if (range[0] >= range[1])
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid range of samples '{}': it is empty", text), {},
                "write --samples 0..64; the second number is exclusive");
}

void parse(RenderOptions& options) {
  options.picture = picture_options(options);
  picture::RenderOptions& render = options.render;
  if (!options.tile.empty()) {
    const auto tile = parse_numbers(options.tile, "N/N", "tile", "write --tile 1/4 to --tile 4/4");
    render.slice.band = tile[0] - 1, render.slice.bands = tile[1];
  }
  if (!options.samples.empty()) set_samples(options.samples, render.slice);
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

constexpr double kWorthAnEstimate = 5;  // seconds

/// Prints the estimate of the rendering and of the whole picture, on which `before` seconds have
/// been spent. `most`: a limit for the noise may end it earlier.
void print_estimate(double before, double seconds, double bytes, bool most) {
  if (seconds < kWorthAnEstimate && bytes < 0x1p30) return;
  clear_progress_bar();
  fmt::print(stderr, "rendering takes {}{} and {}, after {:.0f} s of preparation: {}{} in all\n",
             most ? "at most " : "", time_text(seconds), bytes_text(bytes), before,
             most ? "at most " : "", time_text(before + seconds));
}

/// Prints the noise so far and the remaining time, or at the end the noise that was reached.
void print_noise(const render::NoiseReport& report, double seconds,
                 const shot::RenderSettings& set) {
  const bool end = report.missing <= 0;
  if (!end && seconds < kWorthAnEstimate) return;
  const double limit = 100 * set.noise;
  std::string text = fmt::format("noise {:.1f} % with {:.0f} samples per pixel", 100 * report.noise,
                                 report.samples);
  if (!end) {
    text += fmt::format("; rendering to {:.3g} % takes {} more", limit, time_text(seconds));
  } else if (report.noise > set.noise) {
    double spp = set.spp;
    while (spp < set.spp * report.noise * report.noise / (set.noise * set.noise)) spp *= 2;
    text += fmt::format(", the most that spp allows; {:.3g} % needs about {:.0f}", limit, spp);
  }
  clear_progress_bar();
  fmt::print(stderr, "{}\n", text);
}

/// Renders and writes one picture of the loaded scene.
void render_one(const RenderOptions& options, building::Builder& builder,
                const picture::PicturePlan& plan, double start, picture::ExposureLock& lock) {
  if (learns_only(options)) {
    picture::learn_light(builder, plan, options.guiding);
    fmt::print("{}\n", options.guiding);
    return;
  }
  picture::RenderOptions render = options.render;
  if (!options.work.quiet)
    render.estimate = [&](double seconds, double bytes) {
      print_estimate(stage_times().total_seconds() - start, seconds, bytes,
                     plan.render.settings.noise > 0);
    };
  if (!options.work.quiet)
    render.noise = [&](const render::NoiseReport& report, double seconds) {
      print_noise(report, seconds, plan.render.settings);
    };
  bool warned = false;  // about the exposure
  if (!options.untested)
    render.inspect = [&](const render::PreparedRender& prepared) {
      for (const scout::PreflightFinding& each : scout::preflight(prepared, plan.render.settings)) {
        builder.warn(plan.render.where, each.message, each.hint);
        warned |= each.exposure;
      }
    };
  std::vector<picture::RenderResult> rendered = picture::render_views(builder, plan, render);
  for (picture::RenderResult& each : rendered)
    if (each.image) lock.apply(plan.render.name, *each.image, each.output.settings);
  const std::vector<picture::PictureView> views = picture::picture_views(rendered);
  if (views.empty()) {
    fmt::print("{}\n", options.part);
  } else {
    if (!warned) picture::warn_about_exposure(builder, rendered.front());
    for (const auto& path : picture::write_picture(options.output, views, builder.progress()))
      fmt::print("{}\n", path.string());
  }
  std::fflush(stdout);
}

/// Renders all pictures with one builder. `start`: the seconds of the run before this frame.
void render_all(const std::vector<PlannedPicture>& pictures, building::Builder& builder,
                double start, picture::ExposureLock& lock) {
  for (const auto& [options, plan] : pictures) {
    render_one(options, builder, plan, start, lock);
    start = stage_times().total_seconds();
  }
}

/// Writes the products of the scene, after its pictures.
void finish(const RenderOptions& options, building::Builder& builder) {
  if (learns_only(options)) return;
  if (!options.products.empty())
    for (const auto& path : delivery::write_products(builder, options.products))
      fmt::print("{}\n", path.string());
  std::fflush(stdout);
  picture::remove_checkpoint(options.render);
}

int render_frames(const RenderOptions& options, const loading::SceneSource& source,
                  Progress& progress) {
  const std::vector<int> frames = picture::parse_frames(options.frames);
  for (const int frame : frames) options_at_frame(options, frame);  // check names before any work
  for (const int frame : frames) {  // and the animation before the first picture
    if (options.anyway) break;
    const loading::Loaded loaded = source.at(frame);
    if (!loaded.usable()) break;  // reported at this frame
    for (const PlannedPicture& each : plan_pictures(options, loaded.shot))
      require_placement(each, loaded, loading::Accuracy::bounds);
  }
  std::unique_ptr<SceneAtFrame> now;
  picture::ExposureLock lock;
  double seconds = 0;
  size_t rendered = 0, skipped = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    const double start = stage_times().total_seconds();
    auto next = std::make_unique<SceneAtFrame>(options.scene.load(source, frames[i]), options.work,
                                               progress);
    if (now) next->builder.reuse_from(std::move(now->builder));
    now = std::move(next);
    std::vector<PlannedPicture> pictures = plan_pictures(options, now->loaded.shot, frames[i]);
    if (options.render.resume) skip_finished(pictures, now->loaded.shot, lock);
    if (pictures.empty()) {
      ++skipped;
      continue;
    }
    check_pictures(pictures, *now, progress);
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
      render_all(pictures, now->builder, start, lock);
      finish(options_at_frame(options, frames[i]), now->builder);
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

/// Sends the messages of the process to another file.
void redirect_messages(const std::string& log) {
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0)
    throw Error(ErrorCode::io, fmt::format("cannot write '{}'", log), {},
                "check the free space and the permissions of its folder");
  dup2(file, STDERR_FILENO);
  close(file);
}

/// Renders the parts that lines of the standard input request, until it ends. Each is answered with
/// a line when its file is complete or has failed; only a stop on request ends the process.
void render_requests(const PlannedPicture& picture, SceneAtFrame& scene, Progress& progress) {
  const auto& [options, plan] = picture;
  std::unique_ptr<picture::PartRenderer> parts;
  for (std::string line; std::getline(std::cin, line);) {
    int exit = kDone;
    try {
      const PartRequest request = part_request(line);
      if (!request.log.empty()) redirect_messages(request.log);
      picture::RenderOptions render = options.render;
      set_samples(request.samples, render.slice);
      render.part = request.part, render.checkpoint = request.checkpoint;
      render.resume = !request.checkpoint.empty();
      std::vector<std::filesystem::path> outputs{request.part};
      if (render.resume) outputs.emplace_back(request.checkpoint);
      require_outputs(outputs, loading::file_dependencies(scene.loaded));
      if (!parts)
        parts = std::make_unique<picture::PartRenderer>(scene.builder, plan, options.guiding);
      parts->render(render);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::cancelled) throw;
      exit = print_error(error);
    }
    progress.check();
    fmt::print("{}\n", answer_line(exit));
    std::fflush(stdout);
  }
}

int run_render(RenderOptions options) {
  parse(options);
  Progress& progress = terminal_progress(options.work.bar_mode());
  const loading::SceneSource source = options.scene.source();
  options.picture.source = &source;
  if (!options.frames.empty()) return render_frames(options, source, progress);
  if (const auto& frame = options.scene.frame;
      frame && *frame == std::floor(*frame) && std::fabs(*frame) < 1e9)
    options = with_frame_number(options, static_cast<int>(*frame));
  SceneAtFrame scene(options.scene.load(source, options.scene.frame.value_or(1)), options.work,
                     progress);
  std::vector<PlannedPicture> pictures = plan_pictures(options, scene.loaded.shot);
  check_pictures(pictures, scene, progress);
  if (light_dark_scene(pictures.front(), scene))
    pictures = plan_pictures(options, scene.loaded.shot);
  if (options.part_requests) {
    render_requests(pictures.front(), scene, progress);
    return kDone;
  }
  picture::ExposureLock lock;
  render_all(pictures, scene.builder, 0, lock);
  finish(options, scene.builder);
  options.work.summarise(scene.builder);
  return kDone;
}

}  // namespace

Verb render_verb() {
  return {
      "render", "Renders a picture: an EXR with AOVs, and a PNG next to it.", [](CLI::App& app) {
        auto options = std::make_shared<RenderOptions>();
        add_picture_options(app, *options);
        auto& render = options->render;
        app.add_option("-o,--output", options->output, "Output file, an .exr");
        app.add_option("--products", options->products,
                       "Folder for the products of `vug build`, which are written as well");
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
        app.add_flag("--part-requests", options->part_requests,
                     "Render the parts that lines of the standard input describe, for `vug farm "
                     "run`; needs --guiding")
            ->needs("--guiding")
            ->excludes("--output", "--part", "--checkpoint", "--samples", "--frames", "--preview",
                       "--products");
        options->work.add_to(app);
        return [options] {
          return with_threads(options->work.threads, [&] { return run_render(*options); });
        };
      }};
}

}  // namespace vug::cli
