// SPDX-License-Identifier: Apache-2.0
// The loop over the tiles of a picture, which hands each rendered tile to a sink.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/tile_progress.h>
#include <vug/render/prepare.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace vug::render {

/// Receives the rendered tiles.
class TileSink {
 public:
  virtual ~TileSink() = default;
  /// The sample counts that all tiles reach before any tile continues, in ascending order.
  virtual std::vector<uint32_t> stops(const TileProgress& tiles) const { return {tiles.end}; }
  /// Receives the samples of a tile from TileProgress::done up to `count`, and updates `done`.
  /// Called on all threads.
  virtual void add(size_t tile, const Film& film, uint32_t count) = 0;
  /// All tiles have `count` samples or have converged.
  virtual void reached(uint32_t count) { (void)count; }
  /// See Film::invalid_samples; for all samples so far.
  virtual std::pair<uint64_t, uint64_t> invalid_samples() const = 0;
};

/// Renders the missing samples of the tiles on all threads, after an estimate of the duration.
/// Error(cancelled).
void render_tiles(const PreparedRender& prepared, const TileProgress& tiles, TileSink& sink,
                  const RenderCallbacks& callbacks, Progress& progress);

}  // namespace vug::render
