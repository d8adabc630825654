// SPDX-License-Identifier: Apache-2.0
#include <vug/base/hash.h>
#include <vug/base/maths.h>
#include <vug/base/memory.h>
#include <vug/building/flat_scene.h>
#include <vug/loading/validate.h>
#include <vug/picture/motion.h>
#include <vug/picture/picture.h>
#include <vug/render/kinds.h>
#include <vug/render/working_space.h>
#include <vug/shot/queries.h>
#include <vug/volume/density.h>
#include <vug/volume/fog.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::picture {
namespace {

constexpr const char* kFewerPixels = "use a smaller --size";

template <class Named, class Name>
const auto& find_named(const Named& items, const std::string& name, const std::string& what,
                       Name name_of) {
  std::vector<std::string> names;
  for (const auto& item : items) {
    if (name_of(item) == name) return item;
    names.push_back(name_of(item));
  }
  throw Error(ErrorCode::bad_input, fmt::format("the scene has no {} '{}'", what, name), {},
              suggestion(name, names));
}

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
std::string identity(const render::Scene& scene, const shot::Shot& shot,
                     const PictureOptions& options) {
  const shot::RenderPlan plan = render_plan(shot, options);
  Hasher hash;
  const auto add_all = [&](const auto& values) {
    hash.add_value(values.size());
    if (!values.empty()) hash.add(values.data(), values.size() * sizeof(values[0]));
  };
  hash.add_value(shot.text_digest).add_value(options.eye);
  for (const std::string& text :
       {shot.recipe, plan.name, camera_name(shot, plan), std::string(VUG_VERSION)})
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
uint64_t sample_seed(const shot::Shot& shot, const PictureOptions& options) {
  const uint64_t seed = options.seed.value_or(shot.seed);
  if (!shot.animated) return seed;
  return RandomKey(seed)
      .at("frame")
      .at(static_cast<uint64_t>(std::llround(shot.frame * 1e6)))
      .state();
}

/// Attributes an error to the option that caused it, or, for an empty option, to the text.
Error with_option(const Error& error, const std::string& option, const SourceLocation& where) {
  if (option.empty()) return error.at(where);
  return Error(error.code(), fmt::format("{}: {}", option, error.what()), {}, error.hint());
}

std::string layers_option(const PictureOptions& options) {
  return options.layers.empty() ? "" : "--layers";
}

std::string view_option(const PictureOptions& options) {
  if (options.view.empty()) return options.display.empty() ? "" : "--display";
  return options.display.empty() ? "--view" : "--view and --display";
}

/// The display transform. If the default view of a configuration fails for the working space, the
/// configuration is reported as the cause, not the requested view.
image::ViewSelection view_selection(const shot::RenderPlan& plan, const PictureOptions& options) {
  const image::ViewSelection choice{plan.view, plan.display, options.config};
  try {
    image::view_options(choice, plan.working_space);
  } catch (const Error& error) {
    try {
      image::view_options({{}, {}, options.config}, plan.working_space);
    } catch (const Error&) {
      throw with_option(error, options.config == image::environment_config() ? "$OCIO" : "--ocio",
                        {});
    }
    throw with_option(error, view_option(options), plan.where);
  }
  return choice;
}

/// The AOVs that the scene may have, before its meshes are built.
render::AovPlan early_aovs(const shot::Shot& shot, const shot::RenderPlan& plan,
                           const PictureOptions& options) {
  try {
    return loading::expected_aovs(shot, plan);
  } catch (const Error& error) {
    throw with_option(error, layers_option(options), plan.where);
  }
}

}  // namespace

image::Metadata identifying_metadata(const shot::Shot& shot, const PictureOptions& options) {
  const shot::RenderPlan plan = render_plan(shot, options);
  Hasher settings;
  settings.add_value(shot.text_digest);
  for (const std::string& text :
       {plan.name, camera_name(shot, plan), plan.view, plan.display, options.config.string(),
        fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", fmt::join(plan.size, "x"), plan.noise,
                    plan.exposure, plan.openings, plan.half, plan.multi_part, plan.tiled,
                    options.denoise, options.deep, options.eye, fmt::join(plan.layers, ","),
                    fmt::join(plan.crop, ","))})
    settings.add_value(text.size()).add(text);
  image::Metadata all = {{"vug:recipe", shot.recipe},
                         {"vug:version", VUG_VERSION},
                         {"vug:seed", std::to_string(options.seed.value_or(shot.seed))},
                         {"vug:working_space", image::info(plan.working_space).name},
                         {"vug:spp", std::to_string(plan.spp)},
                         {"vug:settings", settings.finish().hex()}};
  if (shot.animated) all.emplace_back("vug:frame", fmt::format("{}", shot.frame));
  return all;
}

shot::RenderPlan render_plan(const shot::Shot& shot, const PictureOptions& options) {
  shot::RenderPlan plan;
  if (!options.render.empty())
    plan = find_named(shot.renders, options.render, "render",
                      [](const shot::RenderPlan& r) { return r.name; });
  else if (!shot.renders.empty())
    plan = shot.renders.front();
  auto name_of = [](const shot::CameraPlan& camera) { return camera.name; };
  if (!options.camera.empty())
    plan.camera = find_named(shot.cameras, options.camera, "camera", name_of).camera;
  if (!plan.camera && !shot.cameras.empty()) {
    const auto same =
        std::find_if(shot.cameras.begin(), shot.cameras.end(),
                     [&](const shot::CameraPlan& each) { return each.name == plan.name; });
    plan.camera = (same == shot.cameras.end() ? shot.cameras.front() : *same).camera;
  }
  if (options.spp) plan.spp = *options.spp;
  if (options.size) plan.size = {options.size->x, options.size->y};
  if (options.noise) plan.noise = *options.noise;
  if (options.exposure) plan.exposure = *options.exposure;
  if (options.full_float) plan.half = false;
  if (options.multi_part) plan.multi_part = true;
  if (options.tiled) plan.tiled = true;
  if (options.deep) plan.deep = true;
  if (!options.layers.empty()) plan.layers = options.layers;
  if (!options.crop.empty()) plan.crop = options.crop;
  if (options.working_space) plan.working_space = *options.working_space;
  if (!options.view.empty()) plan.view = options.view;
  if (!options.display.empty()) plan.display = options.display;
  return plan;
}

std::string camera_name(const shot::Shot& shot, const shot::RenderPlan& plan) {
  for (const shot::CameraPlan& each : shot.cameras)
    if (plan.camera ? each.camera == plan.camera : each.name == plan.name) return each.name;
  return shot.cameras.empty() ? "" : shot.cameras.front().name;
}

bool is_stereo(const shot::Shot& shot, const PictureOptions& options) {
  const render::CameraPtr camera = render_plan(shot, options).camera;
  return camera && camera->stereo_view(-1);
}

render::Scene build_scene(building::Builder& builder, const shot::RenderPlan& plan,
                          const building::TimeSamples& time_samples) {
  const shot::Shot& shot = builder.shot();
  render::Scene scene;
  building::FlatScene flat = building::flatten_scene(builder, time_samples);
  if (flat.objects.empty() && flat.lights.empty())
    throw Error(ErrorCode::bad_input, "the scene has nothing to show", {},
                "add for instance: volume rock = level_set(..., voxel: 5cm)");
  building::add_default_light(flat, shot.medium.get());
  scene.objects = std::move(flat.objects);
  scene.lights = std::move(flat.lights);
  Box3d bounds;
  for (const render::Object& object : scene.objects) {
    const render::Affine to = object.instance ? object.instance->at(0) : render::Affine();
    Box3f box;
    if (object.mesh)
      for (const Vec3f& p : object.mesh->positions) box.extendBy(to.point(p));
    else if (const Box3d own = object.surface->bounds(); !own.isEmpty())
      box = to.box({Vec3f(own.min), Vec3f(own.max)});
    if (!box.isEmpty()) bounds.extendBy(Box3d(Vec3d(box.min), Vec3d(box.max)));
  }
  scene.medium = shot.medium;
  if (shot.medium_volume)
    scene.medium = shot.medium->with_density(std::make_shared<const volume::Density>(
        volume::fog(builder.level_set(shot.medium_volume))));
  if (bounds.isEmpty()) bounds = Box3d(Vec3d(-1), Vec3d(1));
  scene.camera = plan.camera ? plan.camera : outside_camera(bounds);
  warn_if_inside_solid(builder, plan, shot::shown_objects(shot), *scene.camera);
  return render::in_space(std::move(scene), plan.working_space);
}

PictureJob prepare_picture(building::Builder& builder, const PictureOptions& options,
                           bool whole_film) {
  shot::RenderPlan plan = render_plan(builder.shot(), options);
  const shot::RenderPlan static_plan = plan;
  const building::TimeSamples time_samples = shutter_samples(builder.shot(), options, plan);
  plan.camera = animated_camera(time_samples, options, plan);
  if (options.eye != 0) {
    plan.camera = plan.camera ? plan.camera->stereo_view(options.eye) : nullptr;
    if (!plan.camera)
      throw Error(ErrorCode::bad_input, "--eye: the camera is not a stereo camera", {},
                  "set the distance of its eyes: interaxial 6.5cm");
  }
  PictureJob job;
  job.where = plan.where;
  render::Options& render = job.options;
  render.width = plan.size[0];
  render.height = plan.size[1];
  render.spp = plan.spp;
  render.seed = sample_seed(builder.shot(), options);
  render.sampler = plan.sampler;
  render.integrator = plan.integrator;
  render.noise = plan.noise;
  if (plan.deep) render.deep.emplace().tolerance = plan.deep_tolerance;
  render.openings = plan.openings;
  if (plan.crop.size() == 4) render.crop = {plan.crop[0], plan.crop[1], plan.crop[2], plan.crop[3]};
  render.aovs = early_aovs(builder.shot(), plan, options);
  if (options.denoise && !render.aovs.has("variance"))
    throw Error(ErrorCode::bad_input,
                "--denoise: a picture without the layer 'variance' cannot be denoised", {},
                "add \"variance\", \"albedo\", \"N\" and \"Z\" to its layers");
  job.output.space = plan.working_space;
  job.output.view = view_selection(plan, options);
  require_memory(render::memory_estimate({}, render, whole_film), builder.memory_budget(),
                 fmt::format("a picture of {}x{}", plan.size[0], plan.size[1]), kFewerPixels);
  if (render.aovs.has(render::kMotion))
    render.motion_step = motion_step(builder, options, static_plan);
  job.scene = build_scene(builder, plan, time_samples);
  try {
    render.aovs = render::scene_aovs(job.scene, plan.layers);
  } catch (const Error& error) {
    throw with_option(error, layers_option(options), plan.where);
  }
  require_memory(render::memory_estimate(job.scene, render, whole_film), builder.memory_budget(),
                 "the picture", std::string(kFewerPixels) + " or larger voxels");
  job.output.exposure = plan.exposure;
  job.output.half = plan.half;
  job.output.multi_part = plan.multi_part;
  job.output.tiled = plan.tiled;
  job.output.denoise = options.denoise;
  job.output.camera = job.scene.camera->matrices(static_cast<float>(render.width) /
                                                 static_cast<float>(render.height));
  job.output.metadata = identifying_metadata(builder.shot(), options);
  if (const std::string inexact = plan.integrator ? plan.integrator->inexact() : "";
      !inexact.empty())
    job.output.metadata.emplace_back("vug:inexact", inexact);
  job.header = render::partial_render_header(render);
  job.header.identity = identity(job.scene, builder.shot(), options);
  job.header.notes = to_header_attributes(job.output);
  return job;
}

}  // namespace vug::picture
