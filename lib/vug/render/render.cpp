#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/render/render.h>
#include <vug/render/paths/tile_renderer.h>
#include <vug/render/film/render_state.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>

namespace vug::render {
namespace {

/// Peak of the tree and its building for each triangle: 127, 109 and 105 bytes were measured with
/// 10^5, 10^6 and 5 10^6 triangles of a wavy ball (growth of the resident set); and its corners.
constexpr double kTreeBytes = 125 + 36;
/// The same of a mesh that stands in the scene itself: 86 bytes with 4 10^6 triangles.
constexpr double kStillBytes = 110;
/// A brick of a surface without a mesh in its tree.
constexpr double kBrickBytes = 200;
/// An instance in the tree of the scene and among its parts.
constexpr double kInstanceBytes = 1500;

}  // namespace

image::Image render(const Scene& scene, const Options& options, Progress& progress,
                    const Watch& watch, image::DeepImage* deep) {
  std::optional<ThreadLimit> limit;
  if (options.threads > 0) limit.emplace(options.threads);
  if (options.noise > 0 || watch.pass || watch.save) {
    if (deep)
      throw Error(ErrorCode::bad_input, "a deep picture takes all samples of a pixel at once", {},
                  "render it without noise, checkpoint and preview");
    State state = start(options);
    proceed(scene, options, state, watch, progress);
    return develop(state, options.layers);
  }
  // Blocks are finished one by one, so that only the layers are held.
  const Shooter shooter(scene, options, progress);
  const Region& all = shooter.wanted();
  if (watch.estimate)
    watch.estimate(shooter.seconds(static_cast<double>(all.pixels()) * options.spp));
  image::Image picture(all.width(), all.height(), options.layers.channels());
  if (deep) *deep = image::DeepImage(all.width(), all.height());
  const int tile = std::max(options.tile, 1);
  std::atomic<uint64_t> refused{0}, cut{0};
  progress.begin("rendering", all.blocks(tile));
  parallel_for(all.blocks(tile), [&](size_t index) {
    const Film film =
        shooter.shoot(all.block(index, tile), 0, static_cast<uint32_t>(options.spp), deep);
    develop(film, options.layers, all, picture);
    const auto faults = film.faults();
    refused += faults.first, cut += faults.second;
    progress.advance();
  });
  progress.end();
  if (watch.faults && refused + cut > 0) watch.faults(refused, cut);
  return picture;
}

double memory_estimate(const Scene& scene, const Options& options, bool whole_film) {
  const auto pixels = static_cast<double>(wanted_region(options).pixels());
  double bytes = 4.0 * static_cast<double>(options.layers.channels().size()) * pixels;
  if (whole_film || options.noise > 0) bytes += Film::pixel_bytes(options.layers.gather()) * pixels;
  std::set<const void*> shared;
  if (options.deep)
    bytes += pixels * static_cast<double>(sizeof(std::vector<image::DeepSample>) +
                                          sizeof(image::DeepSample) * options.deep->most);
  for (const Object& object : scene.objects) {
    if (object.placing) bytes += kInstanceBytes;
    if (object.surface && (!object.placing || shared.insert(object.surface.get()).second))
      bytes += kBrickBytes * static_cast<double>(object.surface->bricks().size());
    if (!object.mesh) continue;
    if (object.placing && !shared.insert(object.mesh.get()).second) continue;
    bytes += static_cast<double>(sizeof(Vec3f) * object.mesh->positions.size());
    const bool still = !object.placing && !(object.material && object.material->cut_out());
    bytes +=
        (still ? kStillBytes : kTreeBytes) * static_cast<double>(object.mesh->triangles.size());
  }
  return bytes;
}

}  // namespace vug::render
