// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/render/film/render_state.h>
#include <vug/render/prepare.h>
#include <vug/render/thread_option.h>
#include <vug/render/tile_loop.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <utility>

namespace vug::render {
namespace {

/// Peak memory of the BVH and its construction per triangle: 127, 109 and 105 bytes were measured
/// for 10^5, 10^6 and 5 10^6 triangles of a wavy ball (growth of the resident set); plus its
/// corners.
constexpr double kEmbreeBytes = 125 + 36;
/// A brick of a level set in Embree's BVH.
constexpr double kBrickBytes = 200;
/// An instance in Embree's scene and in the list of objects.
constexpr double kInstanceBytes = 1500;

/// Develops each tile as soon as it is complete, so that only the pictures are kept, not the sums.
class DevelopingSink final : public TileSink {
 public:
  /// `deep` may be null.
  DevelopingSink(const Options& options, TileProgress& tiles, image::DeepImage* deep)
      : options_(options),
        tiles_(tiles),
        picture_(tiles.region.width(), tiles.region.height(), options.aovs.channels()),
        deep_(options.deep ? deep : nullptr) {
    if (deep_) *deep_ = image::DeepImage(tiles.region.width(), tiles.region.height());
  }
  void add(size_t tile, const Film& film, uint32_t count) override {
    develop(film, options_.aovs, tiles_.region, picture_);
    if (deep_) develop(film, *options_.deep, tiles_.region, *deep_);
    tiles_.done[tile] = count;
    const auto [invalid, clamped] = film.invalid_samples();
    invalid_ += invalid, clamped_ += clamped;
  }
  std::pair<uint64_t, uint64_t> invalid_samples() const override { return {invalid_, clamped_}; }
  image::Image take_picture() { return std::move(picture_); }

 private:
  const Options& options_;
  TileProgress& tiles_;
  image::Image picture_;
  image::DeepImage* deep_;
  std::atomic<uint64_t> invalid_{0}, clamped_{0};
};

}  // namespace

image::Image render(const Scene& scene, const Options& options, Progress& progress,
                    const RenderCallbacks& callbacks, image::DeepImage* deep) {
  return render(prepare(scene, options, progress), progress, callbacks, deep);
}

image::Image render(const PreparedRender& prepared, Progress& progress,
                    const RenderCallbacks& callbacks, image::DeepImage* deep) {
  const Options& options = prepared.options;
  if (options.noise > 0 || callbacks.pass || callbacks.save) {
    RenderState state = begin_render(options);
    continue_render(prepared, state, callbacks, progress);
    if (deep && options.deep) *deep = develop(state, *options.deep);
    return develop(state, options.aovs);
  }
  TileProgress tiles(prepared.region, 0, static_cast<uint32_t>(options.spp),
                     std::max(options.tile_size, 1));
  DevelopingSink sink(options, tiles, deep);
  with_threads_of(prepared.options,
                  [&] { render_tiles(prepared, tiles, sink, callbacks, progress); });
  return sink.take_picture();
}

FilmLayout film_layout(const Options& options) {
  return options.aovs.layout(options.deep.has_value());
}

double memory_estimate(const Scene& scene, const Options& options, bool whole_film) {
  const auto pixels = static_cast<double>(render_region(options).pixels());
  const double film_bytes = Film::pixel_bytes(film_layout(options), options.spp);
  double bytes = 4.0 * static_cast<double>(options.aovs.channels().size()) * pixels;
  if (whole_film || options.noise > 0) bytes += film_bytes * pixels;
  if (options.deep) {
    bytes += pixels * static_cast<double>(sizeof(std::vector<image::DeepSample>) +
                                          sizeof(image::DeepSample) * options.deep->max_samples);
    // Lists of fragments grow to twice their size at most.
    const int side = std::max(options.tile_size, 1);
    const int threads = options.threads > 0 ? options.threads : thread_count();
    bytes += 2 * film_bytes * std::min(pixels, 1.0 * threads * side * side);
  }
  std::set<const void*> shared;
  for (const Object& object : scene.objects) {
    if (object.instance) bytes += kInstanceBytes;
    if (object.surface && (!object.instance || shared.insert(object.surface.get()).second))
      bytes += kBrickBytes * static_cast<double>(object.surface->bricks().size());
    if (!object.mesh) continue;
    if (object.instance && !shared.insert(object.mesh.get()).second) continue;
    bytes += static_cast<double>(sizeof(Vec3f) * object.mesh->positions.size());
    const bool in_wide_bvh = !object.instance && !(object.material && object.material->cut_out());
    bytes += (in_wide_bvh ? kTriangleBytes : kEmbreeBytes) *
             static_cast<double>(object.mesh->triangles.size());
  }
  return bytes;
}

}  // namespace vug::render
