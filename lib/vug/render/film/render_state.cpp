// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/render/film/adaptive.h>
#include <vug/render/film/render_state.h>
#include <vug/render/thread_option.h>
#include <vug/render/tile_loop.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <utility>
#include <vector>

namespace vug::render {
namespace {

using SaveClock = std::chrono::steady_clock;

/// Limits of the automatic save interval in seconds: a crash loses only minutes, and large films
/// are not written all the time.
constexpr double kMinSaveInterval = 120, kMaxSaveInterval = 300;

/// The sample counts at which all tiles wait; true: noise is measured and callbacks.pass is called.
/// This happens after 4, 8, 16, ... samples and at the end, whether or not the state is saved.
/// Saving adds stops of its own, because it waits for complete tiles.
std::map<uint32_t, bool> stops_of(const TileProgress& tiles, const Options& options,
                                  const RenderCallbacks& callbacks, uint32_t until) {
  constexpr uint32_t kSaveStep = 256;
  std::map<uint32_t, bool> stops = {{tiles.end, true}};
  if (callbacks.pass || options.noise > 0)
    for (uint32_t n = 4; n < tiles.end - tiles.begin; n *= 2) stops[tiles.begin + n] = true;
  if (callbacks.save)
    for (uint32_t n = kSaveStep; n < tiles.end - tiles.begin; n += kSaveStep)
      stops.try_emplace(tiles.begin + n, false);
  if (until >= tiles.end) return stops;
  stops.erase(stops.upper_bound(until), stops.end());
  stops.try_emplace(until, false);
  return stops;
}

/// Accumulates the tiles in a state. All threads pause while it is saved.
class AccumulatingSink final : public TileSink {
 public:
  AccumulatingSink(const Options& options, RenderState& state, const RenderCallbacks& callbacks,
                   uint32_t until)
      : noise_(options.noise),
        state_(state),
        callbacks_(callbacks),
        stops_(stops_of(state, options, callbacks, until)),
        interval_(callbacks.save_every.value_or(kMinSaveInterval)) {}

  std::vector<uint32_t> stops(const TileProgress&) const override {
    std::vector<uint32_t> counts;
    for (const auto& [count, evaluate] : stops_) counts.push_back(count);
    return counts;
  }
  void add(size_t tile, const Film& film, uint32_t count) override {
    {
      const std::shared_lock<std::shared_mutex> lock(saving_);
      state_.film.merge(film);
      state_.done[tile] = count;
    }
    if (!callbacks_.save || !due()) return;
    const std::unique_lock<std::shared_mutex> lock(saving_);
    if (due()) save();
  }
  void reached(uint32_t count) override {
    if (!stops_.at(count)) return;
    if (noise_ > 0 && count < state_.end) mark_converged(state_, noise_);
    if (noise_ > 0 && callbacks_.noise) report_noise(count);
    if (callbacks_.pass) callbacks_.pass(state_);
  }
  std::pair<uint64_t, uint64_t> invalid_samples() const override {
    return state_.film.invalid_samples();
  }
  void save() {
    if (!callbacks_.save) return;
    const SaveClock::time_point begun = SaveClock::now();
    callbacks_.save(state_);
    const SaveClock::time_point ended = SaveClock::now();
    constexpr double kMaxShare = 0.01;
    const double seconds = std::chrono::duration<double>(ended - begun).count();
    interval_ = callbacks_.save_every.value_or(
        std::clamp(seconds / kMaxShare, kMinSaveInterval, kMaxSaveInterval));
    saved_ = ended.time_since_epoch();
  }

 private:
  /// The time of a sample is that of the samples since the first stop, which costs more.
  void report_noise(uint32_t count) {
    const NoiseReport report = noise_report(state_, noise_);
    const double now = std::chrono::duration<double>(SaveClock::now().time_since_epoch()).count();
    if (!first_) first_.emplace(report.samples, now);
    const auto [samples, begun] = *first_;
    if (count == state_.end) return callbacks_.noise(report, 0);
    const bool early = count - state_.begin < kMinAdaptiveSamples;
    if (early || report.missing <= 0 || report.samples <= samples) return;
    const auto pixels = static_cast<double>(state_.region.pixels());
    const double taken = (report.samples - samples) * pixels;
    callbacks_.noise(report, (now - begun) * report.missing / taken);
  }
  bool due() const {
    const std::chrono::duration<double> since = SaveClock::now().time_since_epoch() - saved_.load();
    return since.count() >= interval_;
  }

  double noise_;
  RenderState& state_;
  const RenderCallbacks& callbacks_;
  std::map<uint32_t, bool> stops_;
  std::shared_mutex saving_;
  std::atomic<SaveClock::duration> saved_ = SaveClock::now().time_since_epoch();
  std::atomic<double> interval_;                    ///< Save interval in seconds.
  std::optional<std::pair<double, double>> first_;  ///< Mean samples and time of the first stop.
};

}  // namespace

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
                {},
                "give a number of samples without 'noise', such as --spp 64, or render the whole "
                "picture");
  const auto line = [&](int band) {
    return region.y0 + static_cast<int>(int64_t{lines} * band / slice.bands);
  };
  const int y0 = line(slice.band), y1 = line(slice.band + 1);
  region.y0 = y0, region.y1 = y1;
  return RenderState({region, slice.begin, end}, film_layout(options));
}

void continue_render(const Scene& scene, const Options& options, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress) {
  continue_render(prepare(scene, options, {nullptr, state.region}, progress), state, callbacks,
                  progress);
}

void continue_render(const PreparedRender& prepared, RenderState& state,
                     const RenderCallbacks& callbacks, Progress& progress, uint32_t until) {
  AccumulatingSink sink(prepared.options, state, callbacks, until);
  try {
    with_threads_of(prepared.options,
                    [&] { render_tiles(prepared, state, sink, callbacks, progress); });
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) sink.save();
    throw;
  }
  sink.save();
}

image::Image develop(const RenderState& state, const AovPlan& aovs) {
  image::Image picture(state.region.width(), state.region.height(), aovs.channels());
  develop(state.film, aovs, state.region, picture);
  return picture;
}

image::DeepImage develop(const RenderState& state, const DeepOptions& deep) {
  image::DeepImage picture(state.region.width(), state.region.height());
  develop(state.film, deep, state.region, picture);
  return picture;
}

}  // namespace vug::render
