// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/render/film/adaptive.h>
#include <vug/render/film/render_state.h>
#include <vug/render/render_tile.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>

namespace vug::render {
namespace {

using Clock = std::chrono::steady_clock;

/// Limits of the automatic save interval in seconds: a crash loses only minutes, and large films
/// are not written all the time.
constexpr double kMinSaveInterval = 120, kMaxSaveInterval = 300;

/// A sample count that all tiles reach before any tile continues.
struct Stop {
  uint32_t count;
  bool evaluate;  ///< Noise is measured and callbacks.pass is called.
};

/// Evaluation happens after 4, 8, 16, ... samples and at the end, whether or not the state is
/// saved. Saving adds stops of its own, because it waits for complete tiles.
std::vector<Stop> stops(const RenderState& state, const Options& options,
                        const RenderCallbacks& callbacks) {
  constexpr uint32_t kSaveStep = 256;
  std::map<uint32_t, bool> stops_at = {{state.end, true}};
  if (callbacks.pass || options.noise > 0)
    for (uint32_t n = 4; n < state.end - state.begin; n *= 2) stops_at[state.begin + n] = true;
  if (callbacks.save)
    for (uint32_t n = kSaveStep; n < state.end - state.begin; n += kSaveStep)
      stops_at.try_emplace(state.begin + n, false);
  std::vector<Stop> list;
  for (const auto& [count, evaluate] : stops_at) list.push_back({count, evaluate});
  return list;
}

/// Upper bound of the missing samples.
uint64_t missing(const RenderState& state) { return samples_missing(state, state.region()); }

uint64_t all_samples(const RenderState& state) {
  return state.region().pixels() * uint64_t{state.end - state.begin};
}

/// Renders tiles into one state on all threads, which pause while it is saved.
class StateRenderer {
 public:
  StateRenderer(const PreparedRender& prepared, RenderState& state,
                const RenderCallbacks& callbacks, Progress& progress)
      : prepared_(prepared),
        state_(state),
        callbacks_(callbacks),
        progress_(progress),
        interval_(callbacks.save_every.value_or(kMinSaveInterval)) {}

  void render_until(uint32_t count) {
    std::vector<size_t> tiles;
    for (size_t i = 0; i < state_.done.size(); ++i)
      if (!state_.converged[i] && state_.done[i] < count) tiles.push_back(i);
    parallel_for(tiles.size(), [&](size_t i) { render_tile(tiles[i], count); });
  }
  void save() {
    if (!callbacks_.save) return;
    const Clock::time_point begun = Clock::now();
    callbacks_.save(state_);
    const Clock::time_point ended = Clock::now();
    constexpr double kMaxShare = 0.01;
    const double seconds = std::chrono::duration<double>(ended - begun).count();
    interval_ = callbacks_.save_every.value_or(
        std::clamp(seconds / kMaxShare, kMinSaveInterval, kMaxSaveInterval));
    saved_ = ended.time_since_epoch();
  }

 private:
  bool due() const {
    const std::chrono::duration<double> since = Clock::now().time_since_epoch() - saved_.load();
    return since.count() >= interval_;
  }
  void render_tile(size_t tile, uint32_t count) {
    const Region region = state_.region().tile(tile, RenderState::kTileSize);
    const uint32_t begin = state_.done[tile];
    const Film film = vug::render::render_tile(prepared_, region, begin, count, progress_);
    {
      const std::shared_lock<std::shared_mutex> lock(saving_);
      state_.film.merge(film);
      state_.done[tile] = count;
    }
    progress_.advance(region.pixels() * (count - begin));
    if (!callbacks_.save || !due()) return;
    const std::unique_lock<std::shared_mutex> lock(saving_);
    if (due()) save();
  }

  const PreparedRender& prepared_;
  RenderState& state_;
  const RenderCallbacks& callbacks_;
  Progress& progress_;
  std::shared_mutex saving_;
  std::atomic<Clock::duration> saved_ = Clock::now().time_since_epoch();
  std::atomic<double> interval_;  ///< Save interval in seconds.
};

}  // namespace

bool RenderState::complete() const { return missing(*this) == 0; }

double RenderState::fraction() const { return fraction_done(*this, region()); }

uint64_t samples_missing(const RenderState& state, const Region& region) {
  uint64_t samples = 0;
  for (size_t i = 0; i < state.done.size(); ++i)
    if (!state.converged[i])
      samples += region.tile(i, RenderState::kTileSize).pixels() * (state.end - state.done[i]);
  return samples;
}

double fraction_done(const RenderState& state, const Region& region) {
  const auto all = static_cast<double>(region.pixels()) * (state.end - state.begin);
  return all > 0 ? 1 - static_cast<double>(samples_missing(state, region)) / all : 1;
}

RenderState begin_render(const Options& options, const RenderSlice& slice) {
  Region region = render_region(options);
  const int lines = region.height();
  if (slice.bands < 1 || slice.band < 0 || slice.band >= slice.bands)
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid tile {} of {}", slice.band + 1, slice.bands));
  if (slice.bands > lines)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} lines cannot be divided into {} tiles", lines, slice.bands));
  const auto spp = static_cast<uint32_t>(options.spp);
  const uint32_t end = slice.end == 0 ? spp : slice.end;
  if (slice.begin >= end || end > spp)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("invalid samples {}..{}: the picture has {} per pixel", slice.begin, end, spp));
  if (options.noise > 0 && (slice.bands > 1 || end - slice.begin < spp))
    throw Error(ErrorCode::bad_input,
                "a part of a picture cannot use 'noise': the number of samples is decided for the "
                "whole picture",
                {}, "remove 'noise', or render the whole picture");
  const auto line = [&](int band) {
    return region.y0 + static_cast<int>(int64_t{lines} * band / slice.bands);
  };
  const int y0 = line(slice.band), y1 = line(slice.band + 1);
  region.y0 = y0, region.y1 = y1;
  RenderState state;
  state.begin = slice.begin;
  state.end = end;
  state.film = Film(region, options.aovs.layout());
  state.done.assign(region.tiles(RenderState::kTileSize), state.begin);
  state.converged.assign(state.done.size(), 0);
  return state;
}

void continue_render(const Scene& scene, const Options& options, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress) {
  continue_render(prepare(scene, options, progress), state, callbacks, progress);
}

void continue_render(const PreparedRender& prepared, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress) {
  const Options& options = prepared.options;
  std::optional<ThreadLimit> limit;
  if (options.threads > 0) limit.emplace(options.threads);
  if (callbacks.estimate)
    callbacks.estimate(estimate_seconds(prepared, static_cast<double>(missing(state)), progress));
  const uint64_t all = all_samples(state);
  progress.begin("rendering", all);
  progress.advance(all - missing(state));
  StateRenderer worker(prepared, state, callbacks, progress);
  try {
    for (const Stop& stop : stops(state, options, callbacks)) {
      // A state that was saved after this stop has already been evaluated here.
      if (std::any_of(state.done.begin(), state.done.end(),
                      [&](uint32_t done) { return done > stop.count; }))
        continue;
      worker.render_until(stop.count);
      if (!stop.evaluate) continue;
      if (options.noise > 0 && stop.count < state.end) {
        const uint64_t needed = missing(state);
        mark_converged(state, options.noise);
        progress.advance(needed - missing(state));
      }
      if (callbacks.pass) callbacks.pass(state);
    }
    progress.end();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) worker.save();
    throw;
  }
  worker.save();
  if (const auto [invalid, clamped] = state.film.invalid_samples();
      callbacks.invalid_samples && invalid + clamped > 0)
    callbacks.invalid_samples(invalid, clamped);
}

image::Image develop(const RenderState& state, const AovPlan& aovs) {
  image::Image image(state.region().width(), state.region().height(), aovs.channels());
  const Region& region = state.region();
  develop(state.film, aovs, region, image);
  return image;
}

}  // namespace vug::render
