// A picture under way: what of it is done, and the sums. It can be stopped and gone on with, and
// parts of one picture can be done apart and put together.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/film/film.h>
#include <vug/render/render.h>

#include <cstdint>
#include <vector>

namespace vug::render {

/// Which part of a picture: some of its lines and some of the samples of their pixels.
struct RenderSlice {
  int band = 0, bands = 1;      ///< Index of the band and number of bands of equal height, from the top.
  uint32_t begin = 0, end = 0;  ///< Samples begin <= i < end of each pixel; end 0: all.
};

struct RenderState {
  static constexpr int kTileSize = 16;  ///< Pixels on a side of what is done at a time.

  uint32_t begin = 0, end = 0;  ///< The samples that are to be taken of each pixel.
  std::vector<uint32_t> done;   ///< For each block: samples from `begin` to here are in the film.
  std::vector<uint8_t> converged;  ///< For each block: 1 once its noise is low enough.
  Film film;

  const Region& region() const { return film.region(); }
  bool complete() const;
  /// PartialRender of the samples that is done or not needed any more, 0 to 1.
  double fraction() const;
};

/// The same for a state whose film is not there, and the samples that are not done, of all pixels
/// together.
double fraction_done(const RenderState& state, const Region& region);
uint64_t samples_missing(const RenderState& state, const Region& region);

/// Nothing done yet. Error(bad_input): a slice that is no part of the picture, or a true part of
/// one whose noise decides on its samples, for which the whole picture is looked at.
RenderState begin_render(const Options& options, const RenderSlice& slice = {});

/// Renders what the state misses. The film's bits depend on nothing but what is in it at the end.
void continue_render(const Scene& scene, const Options& options, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress);

/// The picture of what is done.
image::Image develop(const RenderState& state, const AovPlan& aovs);

}  // namespace vug::render
