// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/film/surface_aov.h>
#include <vug/render/kinds.h>
#include <vug/render/paths/automatic_portals.h>
#include <vug/render/tile_renderer.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace vug::render {
namespace {

const Scene& validated(const Scene& scene, const Options& options) {
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
  return scene;
}

/// Begins the first progress stage before PreparedScene is constructed.
const Scene& announced(const Scene& scene, Progress& progress) {
  progress.begin("preparing the scene", 1);
  return scene;
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

/// Above the dimensions of any path, so that pictures without motion use the same numbers.
constexpr uint32_t kTimeDimension = 1u << 20;

/// Number of additional rays per sample at bright edges.
constexpr uint32_t kExtraRays = 7;
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

TileRenderer::TileRenderer(const Scene& scene, const Options& options, Progress& progress)
    : scene_(validated(scene, options)),
      options_(options),
      progress_(progress),
      sampler_(options.sampler ? options.sampler : make_sampler("sobol")),
      integrator_(options.integrator
                      ? options.integrator
                      : make_integrator("path", {{"max_bounces", options.max_bounces}})),
      world_(std::make_unique<const PreparedScene>(announced(scene, progress))),
      region_(render_region(options)),
      spread_(pixel_angle(*scene.camera, options)),
      is_static_(!scene.camera->moves() && !world_->moves() &&
                 !(options.motion_step && options.aovs.has(kMotion))) {
  progress.end();
  light_paths_ = plan_light_paths(options.aovs, world_->lights().groups());
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const auto samples = static_cast<uint64_t>(options.width) *
                       static_cast<uint64_t>(options.height) * static_cast<uint64_t>(options.spp);
  const auto context = [&] {
    return TrainingContext{*world_, *scene.camera, *sampler_, aspect, samples, options.seed};
  };
  if (options.openings)
    if (const auto portals = find_automatic_portals(context(), progress); !portals.empty())
      world_ = std::make_unique<const PreparedScene>(*world_, scene, portals);
  if (IntegratorPtr ready = integrator_->trained(context(), progress))
    integrator_ = std::move(ready);
  if (options.bright_edges && samples >= kMinSamplesForEdges)
    edges_ = BrightEdges(
        *world_, region_, {options.width, options.height},
        static_cast<uint32_t>(std::clamp(options.spp / 2, kMinEdgeSamples, kMaxEdgeSamples)),
        options.seed, [&](const SampleId& id) { return camera_ray(id, 0.5f); }, progress);
}

Ray TileRenderer::camera_ray(const SampleId& id, float time) const {
  SampleCursor numbers(*sampler_, id);
  const FourPairs four = numbers.four_pairs();  // hardly slower than two pairs
  const Vec2f inside = four[0], lens = four[1];
  const float width = static_cast<float>(options_.width);
  const float height = static_cast<float>(options_.height);
  const Vec2f film((static_cast<float>(id.x) + inside.x) / width,
                   (static_cast<float>(id.y) + inside.y) / height);
  Ray ray = is_static_ ? scene_.camera->ray(film, width / height, lens)
                       : scene_.camera->ray_at(time, film, width / height, lens);
  ray.spread = spread_;
  return ray;
}

/// The rays of all samples of a pixel form one sequence, so that together they are well
/// distributed.
std::vector<Ray> TileRenderer::extra_rays(SampleId id, float time) const {
  std::vector<Ray> rays;
  for (uint32_t k = 0; k < kExtraRays; ++k) {
    id.index += static_cast<uint32_t>(options_.spp);
    rays.push_back(camera_ray(id, time));
  }
  return rays;
}

PathResult TileRenderer::sample(int x, int y, uint32_t index, LightPathRecorder& recorder) const {
  SampleId id;
  id.x = static_cast<uint32_t>(x), id.y = static_cast<uint32_t>(y), id.index = index;
  id.spp = static_cast<uint32_t>(options_.spp), id.seed = options_.seed;
  SampleCursor numbers(*sampler_, id);
  recorder.clear();
  LightPathRecorder* active = light_paths_.colours() > 0 ? &recorder : nullptr;
  const float time = is_static_ ? 0.5f : sampler_->single(id, kTimeDimension);
  std::vector<Ray> extra;
  SampleId camera_id = id;
  if (edges_.at(x, y)) {
    camera_id.spp *= 1 + kExtraRays;
    extra = extra_rays(camera_id, time);
  }
  const Ray ray = camera_ray(camera_id, time);
  if (is_static_) return integrator_->trace(*world_, ray, numbers, active, extra);
  PathResult result = integrator_->trace(world_->at(time), ray, numbers, active, extra);
  result.time = time;
  const float width = static_cast<float>(options_.width);
  const float height = static_cast<float>(options_.height);
  if (options_.motion_step && light_paths_.motion && result.first.hit) {
    const uint32_t object = result.first.object;
    const Vec2f motion = options_.motion_step->motion(
        result.first.position, object, scene_.objects[object].instance.get(), time, width / height);
    recorder.set_motion({motion.x * width, motion.y * height});
  }
  return result;
}

Film TileRenderer::render_tile(const Region& region, uint32_t begin, uint32_t end,
                               image::DeepImage* deep) const {
  Film film(region, options_.aovs.layout());
  DeepPixel depths(options_.deep.value_or(DeepOptions()));
  std::vector<LightPathRecorder> recorders(raytree::kMaxInFlight, LightPathRecorder(light_paths_));
  std::vector<PathResult> results(raytree::kMaxInFlight);
  const size_t each = end - begin, row = each * static_cast<size_t>(region.width());
  const auto pixel = [&](size_t number) {
    return std::pair(region.x0 + static_cast<int>(number % row / each),
                     region.y0 + static_cast<int>(number / row));
  };
  raytree::run_interleaved(
      row * static_cast<size_t>(region.height()),
      [&](size_t number) {
        if (number % row == 0) progress_.check();
        const auto [x, y] = pixel(number);
        const size_t at = number % raytree::kMaxInFlight;
        results[at] = sample(x, y, begin + static_cast<uint32_t>(number % each), recorders[at]);
      },
      [&](size_t number) {
        const auto [x, y] = pixel(number);
        const PathResult& result = results[number % raytree::kMaxInFlight];
        film.add(x, y, result, *scene_.camera,
                 recorders[number % raytree::kMaxInFlight].colours().data());
        if (!deep) return;
        depths.add(result, static_cast<double>(
                               scene_.camera->depth_at(result.time, result.first.position)));
        if ((number + 1) % each == 0) deep->at(x - region_.x0, y - region_.y0) = depths.finish();
      });
  return film;
}

double TileRenderer::estimate_seconds(double samples) const {
  using Clock = std::chrono::steady_clock;
  constexpr size_t kBatch = 64;
  constexpr double kMinSeconds = 0.2;  // seconds
  const auto each = static_cast<uint32_t>(std::min(options_.spp, 16));
  size_t pixels = 0;
  // Busy time of the threads, without their waiting times: a picture has enough tiles to keep all
  // threads busy.
  std::atomic<int64_t> busy{0};
  const auto batch = [&] {
    parallel_for(
        kBatch,
        [&](size_t i) {
          // Pixels all over the picture, by multiples of the golden ratio and of its square root.
          // Several samples per pixel, so that caches are as warm as in a real render.
          const Clock::time_point begin = Clock::now();
          const auto step = static_cast<double>(pixels + i);
          const double u = step * 0.6180339887498949, v = step * 0.7548776662466927;
          const int x = region_.x0 + static_cast<int>((u - std::floor(u)) * region_.width());
          const int y = region_.y0 + static_cast<int>((v - std::floor(v)) * region_.height());
          std::vector<LightPathRecorder> recorders(each, LightPathRecorder(light_paths_));
          raytree::run_interleaved(
              each,
              [&](size_t index) { sample(x, y, static_cast<uint32_t>(index), recorders[index]); },
              [](size_t) {});
          busy += std::chrono::nanoseconds(Clock::now() - begin).count();
        },
        4);
    pixels += kBatch;
    progress_.check();
  };
  if (static_cast<double>(kBatch * each) > 0.02 * samples) return 0;
  batch();  // starts the threads and warms the caches
  busy = 0;
  const auto measured = [&] { return static_cast<double>((pixels - kBatch) * each); };
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  do batch();
  while (elapsed() < kMinSeconds && measured() < 0.02 * samples);
  return 1e-9 * static_cast<double>(busy) / thread_count() / measured() * samples;
}

}  // namespace vug::render
