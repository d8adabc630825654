// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/render/film/surface_aov.h>
#include <vug/render/kinds.h>
#include <vug/render/paths/automatic_portals.h>
#include <vug/render/prepare.h>
#include <vug/render/thread_option.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace vug::render {
namespace {

void require_valid(const Scene& scene, const Options& options) {
  if (!scene.camera) throw Error(ErrorCode::bad_input, "the scene has no camera");
  if (options.width < 1 || options.height < 1)
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid size {} x {}: width and height must be at least 1",
                            options.width, options.height));
  if (options.width > 65535 || options.height > 65535)
    throw Error(ErrorCode::bad_input, "invalid size: width and height must be at most 65535");
  if (options.spp < 1)
    throw Error(ErrorCode::bad_input,
                "invalid number of samples: at least 1 per pixel is required");
  if (options.spp > 1 << 20)
    throw Error(ErrorCode::bad_input,
                "invalid number of samples: at most 1048576 per pixel are possible");
}

LightPathPlan plan_light_paths(const AovPlan& aovs, const std::vector<std::string>& scene_groups) {
  LightPathPlan plan;
  plan.components = aovs.has_components();
  plan.groups = aovs.groups.size();
  plan.motion = aovs.has(kMotion);
  for (const SurfaceAov& aov : surface_aovs())
    if (aovs.has(aov.name)) plan.surface.push_back(&aov);
  for (const AovAttribute& attribute : aovs.attributes) plan.attributes.push_back(attribute.name);
  for (size_t colour = 0; colour < aovs.groups.size(); ++colour)
    for (uint32_t group = 0; group < scene_groups.size(); ++group)
      if (scene_groups[group] == aovs.groups[colour]) plan.group_of[group] = colour;
  return plan;
}

/// Samples per pixel for the detection of edges. A pixel also uses those of its four neighbours;
/// crystals smaller than a pixel are rarely missed.
constexpr int kMinEdgeSamples = 2, kMaxEdgeSamples = 8;
/// Pictures with fewer samples are not worth the detection of edges.
constexpr uint64_t kMinSamplesForEdges = 1u << 16;

/// The angle subtended by a pixel in the centre of the picture, in radians.
float pixel_angle(const Camera& camera, const Options& options) {
  const float width = static_cast<float>(options.width);
  const float aspect = width / static_cast<float>(options.height);
  const auto ray = [&](float x) { return camera.ray({x, 0.5f}, aspect, {0.5f, 0.5f}).direction; };
  return length(ray(0.5f + 1 / width) - ray(0.5f));
}

/// Runs a step of the preparation and returns its wall-clock time in seconds.
template <class Step>
double timed(const Step& step) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  step();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

Region render_region(const Options& options) {
  const Region all{0, 0, options.width, options.height};
  if (options.crop == Region()) return all;
  if (options.crop.empty() || !(options.crop.overlap(all) == options.crop))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid crop x {} to {}, y {} to {}: outside the picture of {} x {}",
                            options.crop.x0, options.crop.x1, options.crop.y0, options.crop.y1,
                            options.width, options.height),
                {}, "give left, top, right and bottom in pixels; right and bottom are exclusive");
  return options.crop;
}

Ray PreparedRender::camera_ray(const SampleId& id, float time) const {
  SampleCursor numbers(*sampler, id);
  const FourPairs four = numbers.four_pairs();  // hardly slower than two pairs
  const Vec2f &inside = four[0], &lens = four[1];
  const float width = static_cast<float>(options.width);
  const float height = static_cast<float>(options.height);
  const Vec2f film((static_cast<float>(id.x) + inside.x) / width,
                   (static_cast<float>(id.y) + inside.y) / height);
  Ray ray = is_static ? scene->camera->ray(film, width / height, lens)
                      : scene->camera->ray_at(time, film, width / height, lens);
  ray.spread = spread;
  return ray;
}

namespace {

/// Learns the light, or continues with what has been learned.
void use_light(PreparedRender& out, const LearnedLightPtr& learned, const TrainingContext& context,
               Progress& progress) {
  auto light = std::make_shared<LearnedLight>(learned ? *learned : LearnedLight());
  if (!learned && out.options.openings)
    out.timings.portals =
        timed([&] { light->portals = find_automatic_portals(context, progress); });
  if (!light->portals.empty())
    out.timings.portals += timed([&] {
      out.world = std::make_shared<const PreparedScene>(*out.world, *out.scene,
                                                        portal_lights(light->portals));
    });
  out.timings.training = timed([&] {
    const TrainingContext with_portals{*out.world,     context.camera,  context.sampler,
                                       context.aspect, context.samples, context.seed};
    if (!learned) light->guiding = out.integrator->learn(with_portals, progress);
    if (light->guiding)
      if (IntegratorPtr guided = out.integrator->guided_by(light->guiding))
        out.integrator = std::move(guided);
  });
  out.learned = std::move(light);
}

PreparedRender prepare_valid(const Scene& scene, const Options& options, const PrepareOptions& part,
                             Progress& progress) {
  PreparedRender out;
  out.scene = &scene;
  out.options = options;
  out.region = part.region.value_or(render_region(options));
  out.sampler = options.sampler ? options.sampler : make_sampler("sobol");
  out.integrator = options.integrator
                       ? options.integrator
                       : make_integrator("path", {{"max_bounces", options.max_bounces}});
  out.spread = pixel_angle(*scene.camera, options);
  out.timings.bvh = timed([&] {
    out.world = run_stage(progress, "BVH and lights", [&] {
      return part.world ? part.world : std::make_shared<const PreparedScene>(scene);
    });
  });
  out.is_static = !scene.camera->moves() && !out.world->moves() &&
                  !(options.motion_step && options.aovs.has(kMotion));
  out.light_paths = plan_light_paths(options.aovs, out.world->lights().groups());
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const auto samples = static_cast<uint64_t>(options.width) *
                       static_cast<uint64_t>(options.height) * static_cast<uint64_t>(options.spp);
  const std::shared_ptr<const PreparedScene> world = out.world;  // without the portals
  use_light(out, part.learned, {*world, *scene.camera, *out.sampler, aspect, samples, options.seed},
            progress);
  if (options.bright_edges && samples >= kMinSamplesForEdges && !out.region.empty())
    out.timings.bright_edges = timed([&] {
      const int rays = std::clamp(options.spp / 2, kMinEdgeSamples, kMaxEdgeSamples);
      out.edges =
          BrightEdges(*out.world, out.region, {options.width, options.height},
                      {.rays_per_pixel = static_cast<uint32_t>(rays),
                       .seed = options.seed,
                       .camera_ray = [&](const SampleId& id) { return out.camera_ray(id, 0.5f); }},
                      progress);
    });
  return out;
}

}  // namespace

PreparedRender prepare(const Scene& scene, const Options& options, const PrepareOptions& part,
                       Progress& progress) {
  require_valid(scene, options);
  return with_threads_of(options, [&] { return prepare_valid(scene, options, part, progress); });
}

PreparedRender prepare(const Scene& scene, const Options& options, Progress& progress) {
  return prepare(scene, options, {}, progress);
}

}  // namespace vug::render
