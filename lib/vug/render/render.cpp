// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/render/film/render_state.h>
#include <vug/render/prepare.h>
#include <vug/render/render_tile.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>

namespace vug::render {
namespace {

/// Peak memory of the BVH and its construction per triangle: 127, 109 and 105 bytes were measured
/// for 10^5, 10^6 and 5 10^6 triangles of a wavy ball (growth of the resident set); plus its
/// corners.
constexpr double kEmbreeBytes = 125 + 36;
/// Bytes per triangle of a mesh in the WideBvh: 86 were measured with 4 10^6 triangles.
constexpr double kWideBvhBytes = 110;
/// A brick of a level set in Embree's BVH.
constexpr double kBrickBytes = 200;
/// An instance in Embree's scene and in the list of objects.
constexpr double kInstanceBytes = 1500;

}  // namespace

image::Image render(const Scene& scene, const Options& options, Progress& progress,
                    const RenderCallbacks& callbacks, image::DeepImage* deep) {
  return render(prepare(scene, options, progress), progress, callbacks, deep);
}

image::Image render(const PreparedRender& prepared, Progress& progress,
                    const RenderCallbacks& callbacks, image::DeepImage* deep) {
  const Options& options = prepared.options;
  std::optional<ThreadLimit> limit;
  if (options.threads > 0) limit.emplace(options.threads);
  if (options.noise > 0 || callbacks.pass || callbacks.save) {
    if (deep)
      throw Error(ErrorCode::bad_input, "a deep picture needs all samples of a pixel at once", {},
                  "render it without noise, checkpoint and preview");
    RenderState state = begin_render(options);
    continue_render(prepared, state, callbacks, progress);
    return develop(state, options.aovs);
  }
  // Tiles are finished one by one, so that only the AOVs are kept, not the sums.
  const Region& all = prepared.region;
  if (callbacks.estimate)
    callbacks.estimate(
        estimate_seconds(prepared, static_cast<double>(all.pixels()) * options.spp, progress));
  image::Image picture(all.width(), all.height(), options.aovs.channels());
  if (deep) *deep = image::DeepImage(all.width(), all.height());
  const int tile = std::max(options.tile_size, 1);
  std::atomic<uint64_t> invalid{0}, clamped{0};
  progress.begin("rendering", all.tiles(tile));
  parallel_for(all.tiles(tile), [&](size_t index) {
    const Film film = render_tile(prepared, all.tile(index, tile), 0,
                                  static_cast<uint32_t>(options.spp), progress, deep);
    develop(film, options.aovs, all, picture);
    const auto invalid_samples = film.invalid_samples();
    invalid += invalid_samples.first, clamped += invalid_samples.second;
    progress.advance();
  });
  progress.end();
  if (callbacks.invalid_samples && invalid + clamped > 0)
    callbacks.invalid_samples(invalid, clamped);
  return picture;
}

double memory_estimate(const Scene& scene, const Options& options, bool whole_film) {
  const auto pixels = static_cast<double>(render_region(options).pixels());
  double bytes = 4.0 * static_cast<double>(options.aovs.channels().size()) * pixels;
  if (whole_film || options.noise > 0) bytes += Film::pixel_bytes(options.aovs.layout()) * pixels;
  std::set<const void*> shared;
  if (options.deep)
    bytes += pixels * static_cast<double>(sizeof(std::vector<image::DeepSample>) +
                                          sizeof(image::DeepSample) * options.deep->max_samples);
  for (const Object& object : scene.objects) {
    if (object.instance) bytes += kInstanceBytes;
    if (object.surface && (!object.instance || shared.insert(object.surface.get()).second))
      bytes += kBrickBytes * static_cast<double>(object.surface->bricks().size());
    if (!object.mesh) continue;
    if (object.instance && !shared.insert(object.mesh.get()).second) continue;
    bytes += static_cast<double>(sizeof(Vec3f) * object.mesh->positions.size());
    const bool in_wide_bvh = !object.instance && !(object.material && object.material->cut_out());
    bytes += (in_wide_bvh ? kWideBvhBytes : kEmbreeBytes) *
             static_cast<double>(object.mesh->triangles.size());
  }
  return bytes;
}

}  // namespace vug::render
