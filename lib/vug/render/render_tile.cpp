// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/render_tile.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

namespace vug::render {
namespace {

/// Above the dimensions of any path, so that pictures without motion use the same numbers.
constexpr uint32_t kTimeDimension = 1u << 20;

/// Number of additional rays per sample at bright edges.
constexpr uint32_t kExtraRays = 7;
/// The rays of all samples of a pixel form one sequence, so that together they are well
/// distributed.
std::vector<Ray> extra_rays(const PreparedRender& prepared, SampleId id, float time) {
  std::vector<Ray> rays;
  for (uint32_t k = 0; k < kExtraRays; ++k) {
    id.index += static_cast<uint32_t>(prepared.options.spp);
    rays.push_back(prepared.camera_ray(id, time));
  }
  return rays;
}

PathResult sample(const PreparedRender& prepared, int x, int y, uint32_t index,
                  LightPathRecorder& recorder) {
  const Options& options = prepared.options;
  SampleId id;
  id.x = static_cast<uint32_t>(x), id.y = static_cast<uint32_t>(y), id.index = index;
  id.spp = static_cast<uint32_t>(options.spp), id.seed = options.seed;
  SampleCursor numbers(*prepared.sampler, id);
  recorder.clear();
  LightPathRecorder* active = prepared.light_paths.colours() > 0 ? &recorder : nullptr;
  const float time = prepared.is_static ? 0.5f : prepared.sampler->single(id, kTimeDimension);
  std::vector<Ray> extra;
  SampleId camera_id = id;
  if (prepared.edges.at(x, y)) {
    camera_id.spp *= 1 + kExtraRays;
    extra = extra_rays(prepared, camera_id, time);
  }
  const Ray ray = prepared.camera_ray(camera_id, time);
  const Integrator& integrator = *prepared.integrator;
  if (prepared.is_static) return integrator.trace(*prepared.world, ray, numbers, active, extra);
  PathResult result = integrator.trace(prepared.world->at(time), ray, numbers, active, extra);
  result.time = time;
  const float width = static_cast<float>(options.width);
  const float height = static_cast<float>(options.height);
  if (options.motion_step && prepared.light_paths.motion && result.first.hit) {
    const uint32_t object = result.first.object;
    const Vec2f motion = options.motion_step->motion(result.first.position, object,
                                                     prepared.scene->objects[object].instance.get(),
                                                     time, width / height);
    recorder.set_motion({motion.x * width, motion.y * height});
  }
  return result;
}

}  // namespace

Film render_tile(const PreparedRender& prepared, const Region& tile, uint32_t begin, uint32_t end,
                 Progress& progress) {
  Film film(tile, film_layout(prepared.options));
  std::vector<LightPathRecorder> recorders(raytree::kMaxInFlight,
                                           LightPathRecorder(prepared.light_paths));
  std::vector<PathResult> results(raytree::kMaxInFlight);
  const size_t each = end - begin, row = each * static_cast<size_t>(tile.width());
  const auto pixel = [&](size_t number) {
    return std::pair(tile.x0 + static_cast<int>(number % row / each),
                     tile.y0 + static_cast<int>(number / row));
  };
  const auto index = [&](size_t number) { return begin + static_cast<uint32_t>(number % each); };
  raytree::run_interleaved(
      row * static_cast<size_t>(tile.height()),
      [&](size_t number) {
        if (number % row == 0) progress.check();
        const auto [x, y] = pixel(number);
        const size_t at = number % raytree::kMaxInFlight;
        results[at] = sample(prepared, x, y, index(number), recorders[at]);
      },
      [&](size_t number) {
        const auto [x, y] = pixel(number);
        const size_t at = number % raytree::kMaxInFlight;
        film.add(x, y, index(number), results[at], *prepared.scene->camera,
                 recorders[at].colours().data());
      });
  return film;
}

double estimate_seconds(const PreparedRender& prepared, double samples, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  constexpr size_t kBatch = 64;
  constexpr double kMinSeconds = 0.2;  // seconds
  const auto each = static_cast<uint32_t>(std::min(prepared.options.spp, 16));
  const Region& region = prepared.region;
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
          const int x = region.x0 + static_cast<int>((u - std::floor(u)) * region.width());
          const int y = region.y0 + static_cast<int>((v - std::floor(v)) * region.height());
          std::vector<LightPathRecorder> recorders(each, LightPathRecorder(prepared.light_paths));
          raytree::run_interleaved(
              each,
              [&](size_t index) {
                sample(prepared, x, y, static_cast<uint32_t>(index), recorders[index]);
              },
              [](size_t) {});
          busy += std::chrono::nanoseconds(Clock::now() - begin).count();
        },
        4);
    pixels += kBatch;
    progress.check();
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
