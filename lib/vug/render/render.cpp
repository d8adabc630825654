#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/render/film.h>
#include <vug/render/kinds.h>
#include <vug/render/layers.h>
#include <vug/render/render.h>
#include <vug/render/world.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vug::render {
namespace {

/// Peak of the tree and its building for each triangle: 127, 109 and 105 bytes were measured with
/// 10^5, 10^6 and 5 10^6 triangles of a wavy ball (growth of the resident set).
constexpr double kTreeBytes = 125;

void require_usable(const Scene& scene, const Options& options) {
  if (!scene.camera) throw Error(ErrorCode::bad_input, "the scene has no camera to render");
  if (options.width < 1 || options.height < 1)
    throw Error(ErrorCode::bad_input,
                fmt::format("a picture cannot be {} x {} pixels", options.width, options.height));
  if (options.width > 65535 || options.height > 65535)
    throw Error(ErrorCode::bad_input, "a picture can be at most 65535 pixels wide or high");
  if (options.spp < 1)
    throw Error(ErrorCode::bad_input, "a picture needs at least one sample for each pixel");
}

TallyPlan plan_tally(const LayerPlan& layers) {
  TallyPlan plan;
  plan.parts = layers.parts();
  return plan;
}

}  // namespace

image::Image render(const Scene& scene, const Options& options, Progress& progress) {
  require_usable(scene, options);
  std::optional<ThreadLimit> limit;
  if (options.threads > 0) limit.emplace(options.threads);
  const SamplerPtr sampler = options.sampler ? options.sampler : make_sampler("sobol");
  const IntegratorPtr integrator =
      options.integrator ? options.integrator
                         : make_integrator("path", {{"max_bounces", options.max_bounces}});
  progress.begin("preparing the scene", 1);
  const World world(scene);
  progress.end();

  const Region whole{0, 0, options.width, options.height};
  image::Image picture(options.width, options.height, options.layers.channels());
  const TallyPlan tally_plan = plan_tally(options.layers);
  const float width = static_cast<float>(options.width);
  const float height = static_cast<float>(options.height);
  const float aspect = width / height;
  const auto render_pixel = [&](Film& film, Tally& tally, int x, int y) {
    SampleId id;
    id.x = static_cast<uint32_t>(x), id.y = static_cast<uint32_t>(y);
    id.spp = static_cast<uint32_t>(options.spp), id.seed = options.seed;
    for (; id.index < id.spp; ++id.index) {
      SampleCursor numbers(*sampler, id);
      const Vec2f inside = numbers.pair(), lens = numbers.pair();
      const Vec2f place((static_cast<float>(x) + inside.x) / width,
                        (static_cast<float>(y) + inside.y) / height);
      const Ray ray = scene.camera->ray(place, aspect, lens);
      tally.clear();
      const PathResult result =
          integrator->trace(world, ray, numbers, tally.colours().empty() ? nullptr : &tally);
      film.add(x, y, result, *scene.camera, tally.colours().data());
    }
  };

  const int tile = std::max(options.tile, 1);
  const size_t tiles = whole.blocks(tile);
  progress.begin("rendering", tiles);
  parallel_for(tiles, [&](size_t index) {
    const Region region = whole.block(index, tile);
    Film film(region, options.layers.gather());
    Tally tally(tally_plan);
    for (int y = region.y0; y < region.y1; ++y) {
      progress.check();
      for (int x = region.x0; x < region.x1; ++x) render_pixel(film, tally, x, y);
    }
    develop(film, options.layers, whole, picture);
    progress.advance();
  });
  progress.end();
  return picture;
}

double memory_estimate(const Scene& scene, const Options& options) {
  double bytes =
      4.0 * static_cast<double>(options.layers.channels().size()) * options.width * options.height;
  for (const Object& object : scene.objects) {
    if (!object.mesh) continue;
    bytes += static_cast<double>(sizeof(Vec3f) * object.mesh->positions.size());
    bytes += kTreeBytes * static_cast<double>(object.mesh->triangles.size());
  }
  return bytes;
}

}  // namespace vug::render
