// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hash.h>
#include <vug/base/maths.h>
#include <vug/base/memory.h>
#include <vug/building/flat_scene.h>
#include <vug/loading/validate.h>
#include <vug/picture/dicing_view.h>
#include <vug/picture/motion.h>
#include <vug/picture/picture.h>
#include <vug/render/kinds.h>
#include <vug/render/working_space.h>
#include <vug/shot/queries.h>
#include <vug/shot/selection.h>
#include <vug/volume/density.h>
#include <vug/volume/fog.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::picture {
namespace {

constexpr const char* kFewerPixels = "use a smaller --size";

/// A camera that sees the whole box from a raised corner.
render::CameraPtr outside_camera(const Box3d& box) {
  constexpr double kFov = 45 * kPi / 180;
  const Vec3d centre = box.center();
  const double reach = 0.5 * box.size().length() / maths::sin(kFov / 2);
  const Vec3d eye = centre + Vec3d(-0.55, 0.4, 0.75).normalized() * std::max(reach, 1e-3);
  return render::make_camera(
      "perspective", {{"eye", eye}, {"target", centre}, {"fov", Number{kFov, Dimension::angle}}});
}

/// Warns about a camera inside a solid, which is hardly ever intended.
void warn_if_inside_solid(building::Builder& builder, const shot::RenderPlan& plan,
                          const std::vector<shot::ObjectPlan>& objects,
                          const render::Camera& camera) {
  const Vec3d eye(camera.position());
  const auto holds_eye = [&](const shot::ObjectPlan& object) {
    const shot::VolumePtr& volume = object.mesh->volume;
    return volume && builder.level_set(volume).value(eye) < 0;
  };
  const auto solid = std::find_if(objects.begin(), objects.end(), holds_eye);
  if (solid == objects.end()) return;
  SourceLocation where = plan.where;
  for (const shot::CameraPlan& declared : builder.shot().cameras)
    if (declared.camera.get() == &camera) where = declared.where;
  builder.warn(where, fmt::format("the camera is inside the solid of '{}'", solid->name),
               "move its eye out of the solid");
}

/// A hash that differs for pictures of different scenes, cameras and renders, whether these are
/// chosen by options or by the scene.
std::string identity(const render::Scene& scene, const shot::Shot& shot, const PicturePlan& plan) {
  Hasher hash;
  const auto add_all = [&](const auto& values) {
    hash.add_value(values.size());
    if (!values.empty()) hash.add(values.data(), values.size() * sizeof(values[0]));
  };
  hash.add_value(shot.text_digest).add_value(plan.options.eye);
  for (const auto& [setting, value] : plan.options.settings)
    if (setting == "lights" || setting == "objects" || setting == "air")
      add_all(setting + " " + to_string(value));
  for (const std::string& text :
       {shot.recipe, plan.render.name, camera_name(shot, plan.render), std::string(VUG_VERSION)})
    add_all(text);
  std::set<const void*> known;
  for (const render::Object& object : scene.objects) {
    add_all(object.name);
    if (object.instance)
      for (const render::Affine& step : object.instance->keyframes())
        for (const Vec3f& column : {step.x, step.y, step.z, step.origin})
          hash.add(&column, sizeof column);
    hash.add_value(known.size());
    if (object.surface) {
      if (!known.insert(object.surface.get()).second) continue;
      hash.add_value(object.surface->voxel());
      add_all(object.surface->bricks());
      continue;
    }
    if (!known.insert(object.mesh.get()).second) continue;
    add_all(object.mesh->positions);
    add_all(object.mesh->triangles);
    add_all(object.mesh->normals);
    for (const auto& attribute : object.mesh->attributes) add_all(attribute.values);
  }
  return hash.finish().hex();
}

/// The sampling seed, different in each frame of an animated scene: static noise looks like dirt.
uint64_t sample_seed(const shot::Shot& shot, const PicturePlan& plan) {
  const uint64_t seed = plan.options.seed.value_or(shot.seed);
  if (!shot.animated) return seed;
  return RandomKey(seed)
      .at("frame")
      .at(static_cast<uint64_t>(std::llround(shot.frame * 1e6)))
      .state();
}

/// Attributes an error to the option that replaced the setting, or to the text.
Error with_cause(const Error& error, const PicturePlan& plan, const std::string& setting) {
  const std::string option = plan.option_for(setting);
  if (option.empty()) return error.at(plan.render.where);
  return Error(error.code(), fmt::format("{}: {}", option, error.what()), {}, error.hint());
}

/// The error of a view or display. If the default view of a configuration fails for the working
/// space, the configuration is reported as the cause.
Error view_error(const Error& error, const PicturePlan& plan) {
  const std::filesystem::path& config = plan.options.config;
  std::string cause;
  try {
    image::view_options({{}, {}, config}, plan.render.settings.working_space);
    const std::string view = plan.option_for("view"), display = plan.option_for("display");
    cause = view + (view.empty() || display.empty() ? "" : " and ") + display;
  } catch (const Error&) {
    cause = config == image::environment_config() ? "$OCIO" : "--ocio";
  }
  if (cause.empty()) return error.at(plan.render.where);
  return Error(error.code(), fmt::format("{}: {}", cause, error.what()), {}, error.hint());
}

void require_view(const PicturePlan& plan) {
  const shot::RenderSettings& settings = plan.render.settings;
  try {
    image::view_options({settings.view, settings.display, plan.options.config},
                        settings.working_space);
  } catch (const Error& error) {
    throw view_error(error, plan);
  }
}

/// The AOVs that the scene may have, before its meshes are built.
render::AovPlan early_aovs(const shot::Shot& shot, const PicturePlan& plan) {
  try {
    return loading::expected_aovs(shot, plan.render);
  } catch (const Error& error) {
    throw with_cause(error, plan, "layers");
  }
}

/// The settings of the renderer, apart from the AOVs and the motion.
render::Options renderer_options(const shot::Shot& shot, const PicturePlan& plan) {
  const shot::RenderSettings& settings = plan.render.settings;
  render::Options options;
  options.width = settings.size[0];
  options.height = settings.size[1];
  options.spp = settings.spp;
  options.seed = sample_seed(shot, plan);
  options.sampler = settings.sampler;
  options.integrator = settings.integrator;
  options.noise = settings.noise;
  if (settings.deep) options.deep.emplace().tolerance = settings.deep_tolerance;
  options.openings = settings.openings;
  if (const std::vector<int>& crop = settings.crop; !crop.empty())
    options.crop = {crop[0], crop[1], crop[2], crop[3]};
  return options;
}

PictureOutput picture_output(const shot::Shot& shot, const PicturePlan& plan,
                             const render::Camera& camera) {
  const shot::RenderSettings& settings = plan.render.settings;
  PictureOutput output;
  output.settings = settings;
  output.config = plan.options.config;
  output.camera =
      camera.matrices(static_cast<float>(settings.size[0]) / static_cast<float>(settings.size[1]));
  output.metadata = identifying_metadata(shot, plan);
  if (const std::string inexact = settings.integrator ? settings.integrator->inexact() : "";
      !inexact.empty())
    output.metadata.emplace_back("vug:inexact", inexact);
  return output;
}

/// The camera of the plan while the shutter is open, or one of its eyes.
render::CameraPtr picture_camera(const PicturePlan& plan,
                                 const building::TimeSamples& time_samples) {
  render::CameraPtr camera = animated_camera(time_samples, plan);
  if (plan.options.eye == 0) return camera;
  if (camera) camera = camera->stereo_view(plan.options.eye);
  if (!camera)
    throw Error(ErrorCode::bad_input, "--eye: the camera is not a stereo camera", {},
                "set the distance of its eyes: interaxial 6.5cm");
  return camera;
}

}  // namespace

render::Scene build_scene(building::Builder& builder, const PicturePlan& plan,
                          const building::TimeSamples& time_samples) {
  const shot::Shot& shot = *plan.shown;
  const shot::RenderSettings& settings = plan.render.settings;
  const shot::MediumPlan* air = shot::find_air(shot, settings);
  render::Scene scene;
  building::FlatScene flat = building::flatten_scene(builder, shot, time_samples);
  if (flat.objects.empty() && flat.lights.empty())
    throw Error(ErrorCode::bad_input, "the scene has nothing to show", {},
                "add for instance: volume rock = level_set(..., voxel: 5cm)");
  Progress& progress = builder.progress();
  const CancellableScope scope(progress);
  progress.begin("assembling the scene");
  if (!settings.lights) building::add_default_light(flat, air ? air->medium.get() : nullptr);
  scene.objects = std::move(flat.objects);
  scene.lights = std::move(flat.lights);
  Box3d bounds;
  for (const render::Object& object : scene.objects) bounds.extendBy(object_bounds(object));
  if (air) scene.medium = air->medium;
  if (air && air->volume)
    scene.medium = air->medium->with_density(
        std::make_shared<const volume::Density>(volume::fog(builder.level_set(air->volume))));
  if (bounds.isEmpty()) bounds = Box3d(Vec3d(-1), Vec3d(1));
  scene.omitted = shot::omitted_objects(builder.shot(), shot);
  scene.camera = settings.camera ? settings.camera : outside_camera(bounds);
  building::dice_objects(
      builder, shot, dicing_view(builder.shot(), plan, time_samples, scene.camera), scene.objects);
  warn_if_inside_solid(builder, plan.render, shot::shown_objects(shot), *scene.camera);
  scene = render::in_space(std::move(scene), settings.working_space);
  progress.end();
  return scene;
}

PictureJob prepare_picture(building::Builder& builder, const PicturePlan& plan, bool whole_film) {
  const shot::Shot& shot = builder.shot();
  const building::TimeSamples time_samples = shutter_samples(shot, plan);
  PicturePlan moving = plan;
  moving.render.settings.camera = picture_camera(plan, time_samples);
  PictureJob job;
  render::Options& render = job.options;
  render = renderer_options(shot, plan);
  render.aovs = early_aovs(*plan.shown, plan);
  require_view(plan);
  require_memory(render::memory_estimate({}, render, whole_film), builder.memory_budget(),
                 fmt::format("a picture of {}x{}", render.width, render.height), kFewerPixels);
  if (render.aovs.has(render::kMotion)) render.motion_step = motion_step(builder, plan);
  job.scene = build_scene(builder, moving, time_samples);
  try {
    render.aovs = render::scene_aovs(job.scene, plan.render.settings.layers);
  } catch (const Error& error) {
    throw with_cause(error, plan, "layers");
  }
  require_memory(render::memory_estimate(job.scene, render, whole_film), builder.memory_budget(),
                 "the picture", std::string(kFewerPixels) + " or larger voxels");
  job.output = picture_output(shot, plan, *job.scene.camera);
  return job;
}

render::PartialRenderHeader file_header(const PictureJob& job, const shot::Shot& shot,
                                        const PicturePlan& plan) {
  render::PartialRenderHeader header = render::partial_render_header(job.options);
  header.identity = identity(job.scene, shot, plan);
  header.notes = to_header_attributes(job.output);
  return header;
}

}  // namespace vug::picture
