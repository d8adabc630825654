// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/render/render_tile.h>
#include <vug/render/tile_loop.h>

#include <algorithm>
#include <optional>

namespace vug::render {
namespace {

std::vector<size_t> unfinished_tiles(const TileProgress& tiles, uint32_t count) {
  std::vector<size_t> list;
  for (size_t i = 0; i < tiles.done.size(); ++i)
    if (!tiles.converged[i] && tiles.done[i] < count) list.push_back(i);
  return list;
}

}  // namespace

void render_tiles(const PreparedRender& prepared, const TileProgress& tiles, TileSink& sink,
                  const RenderCallbacks& callbacks, Progress& progress) {
  if (callbacks.estimate)
    callbacks.estimate(run_stage(progress, "estimating the time", [&] {
      return estimate_seconds(prepared, static_cast<double>(tiles.missing()), progress);
    }));
  progress.begin("rendering", tiles.samples());
  progress.advance(tiles.samples() - tiles.missing());
  for (const uint32_t count : sink.stops(tiles)) {
    // Tiles that were saved after this stop have already been evaluated here.
    if (std::any_of(tiles.done.begin(), tiles.done.end(),
                    [&](uint32_t done) { return done > count; }))
      continue;
    const std::vector<size_t> unfinished = unfinished_tiles(tiles, count);
    parallel_for(unfinished.size(), [&](size_t i) {
      const size_t tile = unfinished[i];
      const uint32_t begin = tiles.done[tile];
      const Film film = render_tile(prepared, tiles.tile(tile), begin, count, progress);
      sink.add(tile, film, count);
      progress.advance(film.region().pixels() * (count - begin));
    });
    const uint64_t missing = tiles.missing();
    sink.reached(count);
    progress.advance(missing - tiles.missing());
  }
  progress.end();
  if (!callbacks.invalid_samples) return;
  const auto [invalid, clamped] = sink.invalid_samples();
  if (invalid + clamped > 0) callbacks.invalid_samples(invalid, clamped);
}

}  // namespace vug::render
