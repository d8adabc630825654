// SPDX-License-Identifier: Apache-2.0
// The state of a render in progress, its continuation, and the decision when it is saved
// (AccumulatingSink). A render can be interrupted and resumed, and slices of one picture can be
// rendered separately and merged.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/film.h>
#include <vug/render/film/tile_progress.h>
#include <vug/render/render.h>

#include <cstdint>
#include <limits>
#include <utility>

namespace vug::render {

/// A slice of a picture: a band of its lines, and a range of samples of their pixels.
struct RenderSlice {
  int band = 0,
      bands = 1;  ///< Index of the band from the top, and number of bands of equal height.
  uint32_t begin = 0, end = 0;  ///< Samples begin <= i < end of each pixel; end 0: all.
};

struct RenderState : TileProgress {
  Film film;  ///< Contains the samples that are done.

  RenderState() = default;
  RenderState(TileProgress tiles, const FilmLayout& layout)
      : TileProgress(std::move(tiles)), film(region, layout) {}
};

/// Returns an empty state. Throws Error(bad_input) if the slice is outside the picture, or if the
/// slice is not the whole picture but a noise threshold requires the whole picture.
RenderState begin_render(const Options& options, const RenderSlice& slice = {});

/// Renders the missing samples. The film's bits depend only on the samples it finally contains.
void continue_render(const Scene& scene, const Options& options, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress);
/// `until`: the number of samples per pixel after which to stop, counted from the first.
void continue_render(const PreparedRender& prepared, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress,
                     uint32_t until = std::numeric_limits<uint32_t>::max());

/// The pictures of the samples that are done. A deep picture requires a state that was begun with
/// Options::deep.
image::Image develop(const RenderState& state, const AovPlan& aovs);
image::DeepImage develop(const RenderState& state, const DeepOptions& deep);

}  // namespace vug::render
