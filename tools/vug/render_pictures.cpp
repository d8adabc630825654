// SPDX-License-Identifier: Apache-2.0
#include "render_pictures.h"
#include "arguments.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/render_choice.h>

#include <cstdio>

namespace vug::cli {
namespace {

/// The options for one picture: its render block and, if there are several, its file names.
RenderOptions options_of(const RenderOptions& options, const std::string& render, bool several) {
  RenderOptions out = options;
  out.picture.render = render;
  if (!several) return out;
  for (std::string* path : {&out.output, &out.preview})
    if (!path->empty()) *path = picture::path_of_render(*path, render).string();
  out.render.preview = out.preview;
  return out;
}

void require_picture_files(const RenderOptions& options, const loading::Loaded& loaded,
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
  require_outputs(outputs, loading::file_dependencies(loaded));
}

}  // namespace

void add_picture_options(CLI::App& app, RenderOptions& options) {
  options.scene.add_to(app, &options.work);
  picture::PictureOptions& picture = options.picture;
  app.add_option("--sample-seed", picture.seed,
                 "Seed of the samples; --seed changes the scene itself")
      ->check(seed_number());
  app.add_option("--camera", picture.camera, "Name of the camera");
  app.add_option("--render", options.renders,
                 "Names of the render blocks, or `all`; required if the scene has several, whose "
                 "files are then named OUTPUT_RENDER.exr")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME");
  app.add_option("--eye", options.eye, "Render only one view of a stereo camera: left or right")
      ->check(one_of({"left", "right"}));
  app.add_flag("--anyway", options.anyway,
               "Render even if the camera or a light is in rock, a prop floats, or a void is "
               "filled");
  app.add_flag("--untested", options.untested,
               "Do not test before the render whether the picture will be black, burnt out or "
               "empty");
  app.add_option("--ocio", options.ocio, "OpenColorIO configuration for the PNG; default $OCIO");
  options.settings.add_to(app);
}

picture::PictureOptions picture_options(const RenderOptions& options) {
  picture::PictureOptions picture = options.picture;
  picture.settings = options.settings.values();
  if (!options.scene.quality.empty())
    picture.settings.emplace_back("quality", Value::Name{options.scene.quality});
  picture.config = options.ocio;
  if (options.ocio.empty()) picture.config = image::environment_config();
  if (!picture.seed) picture.seed = options.scene.seed;
  if (!options.eye.empty()) picture.eye = options.eye == "left" ? -1 : 1;
  return picture;
}

bool learns_only(const RenderOptions& options) {
  return options.output.empty() && options.part.empty();
}

RenderOptions with_frame_number(const RenderOptions& options, int frame) {
  RenderOptions out = options;
  for (std::string* path :
       {&out.output, &out.part, &out.checkpoint, &out.products, &out.preview, &out.guiding})
    if (picture::has_frame_number(*path)) *path = picture::frame_path(*path, frame).string();
  out.render.part = out.part, out.render.checkpoint = out.checkpoint;
  out.render.preview = out.preview, out.render.guiding = out.guiding;
  return out;
}

RenderOptions options_at_frame(const RenderOptions& options, int frame) {
  for (const std::string* path :
       {&options.output, &options.part, &options.checkpoint, &options.products, &options.guiding})
    if (!path->empty())
      picture::frame_path(*path, frame);  // throws for a name without a placeholder
  RenderOptions out = with_frame_number(options, frame);
  if (out.checkpoint.empty()) out.render.resume = false;  // only complete frames are kept
  return out;
}

std::vector<PlannedPicture> plan_pictures(const RenderOptions& options, const shot::Shot& shot,
                                          std::optional<int> frame) {
  const std::vector<std::string> names = picture::choose_renders(shot, options.renders);
  const bool several = names.size() > 1;
  if (several && (!options.part.empty() || !options.checkpoint.empty() || !options.guiding.empty()))
    throw Error(ErrorCode::bad_input,
                fmt::format("a partial render, a checkpoint and a guiding file belong to one "
                            "picture, but {} renders are chosen",
                            names.size()),
                {}, fmt::format("render them one at a time: --render {}", names.front()));
  std::vector<PlannedPicture> pictures;
  for (const std::string& name : names) {
    RenderOptions one = options_of(options, name, several);
    if (frame) one = options_at_frame(one, *frame);
    picture::PicturePlan plan = picture::plan_picture(shot, one.picture);
    pictures.push_back({std::move(one), std::move(plan)});
  }
  return pictures;
}

void require_placement(const PlannedPicture& picture, const loading::Loaded& loaded,
                       loading::Accuracy accuracy) {
  const auto& [options, plan] = picture;
  if (options.anyway) return;
  Diagnostics mistakes;
  loading::check_placement(
      loaded, {picture::camera_name(loaded.shot, plan.render), accuracy, plan.shown.get()},
      mistakes);
  if (!mistakes.has_errors()) return;
  clear_progress_bar();
  fmt::print(stderr, "{}the render was not started; --anyway renders the scene as it is\n",
             loaded.report(mistakes));
  throw ExitRequest{kUnusable};
}

void check_pictures(const std::vector<PlannedPicture>& pictures, SceneAtFrame& scene,
                    Progress& progress) {
  for (const auto& [options, plan] : pictures) require_picture_files(options, scene.loaded, plan);
  for (const PlannedPicture& each : pictures) {
    if (each.options.anyway) continue;
    scene.builder.compute_deferred(*each.plan.shown);
    run_stage(progress, "checking the placement",
              [&] { require_placement(each, scene.loaded, loading::Accuracy::exact); });
  }
}

void skip_finished(std::vector<PlannedPicture>& pictures, const shot::Shot& shot,
                   picture::ExposureLock& lock) {
  std::erase_if(pictures, [&](const PlannedPicture& each) {
    const bool done =
        !each.options.output.empty() && picture::is_finished(each.options.output, shot, each.plan);
    if (done) picture::remove_checkpoint(each.options.render);
    if (done) lock.take(each.plan.render.name, each.options.output);
    return done;
  });
}

}  // namespace vug::cli
