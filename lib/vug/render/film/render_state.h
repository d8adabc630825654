// SPDX-License-Identifier: Apache-2.0
// The state of a render in progress: its sums and how much is done. A render can be interrupted and
// resumed, and slices of one picture can be rendered separately and merged.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/film.h>
#include <vug/render/render.h>

#include <cstdint>
#include <vector>

namespace vug::render {

/// A slice of a picture: a band of its lines, and a range of samples of their pixels.
struct RenderSlice {
  int band = 0,
      bands = 1;  ///< Index of the band from the top, and number of bands of equal height.
  uint32_t begin = 0, end = 0;  ///< Samples begin <= i < end of each pixel; end 0: all.
};

struct RenderState {
  static constexpr int kTileSize = 16;  ///< Side of a tile in pixels.

  uint32_t begin = 0, end = 0;  ///< The range of samples to be taken of each pixel.
  std::vector<uint32_t>
      done;  ///< For each tile: samples from `begin` up to this one are in the film.
  std::vector<uint8_t> converged;  ///< For each tile: 1 once its noise is low enough.
  Film film;

  const Region& region() const { return film.region(); }
  bool complete() const;
  /// The fraction of samples that are done or no longer needed, 0 to 1.
  double fraction() const;
};

/// Completed fraction, for a state without a film, and the number of missing samples of all pixels.
double fraction_done(const RenderState& state, const Region& region);
uint64_t samples_missing(const RenderState& state, const Region& region);

/// Returns an empty state. Throws Error(bad_input) if the slice is outside the picture, or if the
/// slice is not the whole picture but a noise threshold requires the whole picture.
RenderState begin_render(const Options& options, const RenderSlice& slice = {});

/// Renders the missing samples. The film's bits depend only on the samples it finally contains.
void continue_render(const Scene& scene, const Options& options, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress);
void continue_render(const PreparedRender& prepared, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress);

/// The picture of the samples that are done.
image::Image develop(const RenderState& state, const AovPlan& aovs);

}  // namespace vug::render
