#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/render/film/adaptive.h>
#include <vug/render/paths/tile_renderer.h>
#include <vug/render/film/render_state.h>

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

/// Seconds between two savings that nobody asked for: a failure shall not cost more than minutes,
/// nor shall hundreds of megabytes go to disk in each.
constexpr double kLeastPause = 120, kMostPause = 300;

/// A count of samples that all blocks are brought to before any gets more.
struct Stop {
  uint32_t count;
  bool look;  ///< The picture is looked at: noise is measured, a preview shown.
};

/// It is looked at after 4, 8, 16, ... samples and the last; whether it is also saved now and then
/// must not change when. Saving asks for stops of its own, as it waits for whole blocks.
std::vector<Stop> stops(const State& state, const Options& options, const Watch& watch) {
  constexpr uint32_t kSaved = 256;
  std::map<uint32_t, bool> looks = {{state.end, true}};
  if (watch.pass || options.noise > 0)
    for (uint32_t n = 4; n < state.end - state.begin; n *= 2) looks[state.begin + n] = true;
  if (watch.save)
    for (uint32_t n = kSaved; n < state.end - state.begin; n += kSaved)
      looks.try_emplace(state.begin + n, false);
  std::vector<Stop> list;
  for (const auto& [count, look] : looks) list.push_back({count, look});
  return list;
}

/// Samples that the blocks still need at most.
uint64_t missing(const State& state) { return samples_missing(state, state.region()); }

uint64_t all_samples(const State& state) {
  return state.region().pixels() * uint64_t{state.end - state.begin};
}

/// Threads write blocks of their own into one state, and wait while it is saved.
class Work {
 public:
  Work(const Shooter& shooter, State& state, const Watch& watch, Progress& progress)
      : shooter_(shooter),
        state_(state),
        watch_(watch),
        progress_(progress),
        every_(watch.save_every.value_or(kLeastPause)) {}

  void up_to(uint32_t count) {
    std::vector<size_t> blocks;
    for (size_t i = 0; i < state_.done.size(); ++i)
      if (!state_.settled[i] && state_.done[i] < count) blocks.push_back(i);
    parallel_for(blocks.size(), [&](size_t i) { render_block(blocks[i], count); });
  }
  void save() {
    if (!watch_.save) return;
    const Clock::time_point begun = Clock::now();
    watch_.save(state_);
    const Clock::time_point ended = Clock::now();
    constexpr double kShare = 0.01;
    const double seconds = std::chrono::duration<double>(ended - begun).count();
    every_ = watch_.save_every.value_or(std::clamp(seconds / kShare, kLeastPause, kMostPause));
    saved_ = ended.time_since_epoch();
  }

 private:
  bool due() const {
    const std::chrono::duration<double> since = Clock::now().time_since_epoch() - saved_.load();
    return since.count() >= every_;
  }
  void render_block(size_t block, uint32_t count) {
    const Region region = state_.region().block(block, State::kBlock);
    const uint32_t begin = state_.done[block];
    const Film film = shooter_.shoot(region, begin, count);
    {
      const std::shared_lock<std::shared_mutex> lock(saving_);
      state_.film.merge(film);
      state_.done[block] = count;
    }
    progress_.advance(region.pixels() * (count - begin));
    if (!watch_.save || !due()) return;
    const std::unique_lock<std::shared_mutex> lock(saving_);
    if (due()) save();
  }

  const Shooter& shooter_;
  State& state_;
  const Watch& watch_;
  Progress& progress_;
  std::shared_mutex saving_;
  std::atomic<Clock::duration> saved_ = Clock::now().time_since_epoch();
  std::atomic<double> every_;  ///< Seconds from one saving to the next.
};

}  // namespace

bool State::complete() const { return missing(*this) == 0; }

double State::fraction() const { return fraction_done(*this, region()); }

uint64_t samples_missing(const State& state, const Region& region) {
  uint64_t samples = 0;
  for (size_t i = 0; i < state.done.size(); ++i)
    if (!state.settled[i])
      samples += region.block(i, State::kBlock).pixels() * (state.end - state.done[i]);
  return samples;
}

double fraction_done(const State& state, const Region& region) {
  const auto all = static_cast<double>(region.pixels()) * (state.end - state.begin);
  return all > 0 ? 1 - static_cast<double>(samples_missing(state, region)) / all : 1;
}

State start(const Options& options, const Share& share) {
  Region region = wanted_region(options);
  const int lines = region.height();
  if (share.tiles < 1 || share.tile < 0 || share.tile >= share.tiles)
    throw Error(ErrorCode::bad_input,
                fmt::format("there is no tile {} of {}", share.tile + 1, share.tiles));
  if (share.tiles > lines)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} lines cannot be shared out to {} tiles", lines, share.tiles));
  const auto spp = static_cast<uint32_t>(options.spp);
  const uint32_t end = share.end == 0 ? spp : share.end;
  if (share.begin >= end || end > spp)
    throw Error(ErrorCode::bad_input, fmt::format("samples {}..{} are no part of a picture of {}",
                                                  share.begin, end, spp));
  if (options.noise > 0 && (share.tiles > 1 || end - share.begin < spp))
    throw Error(ErrorCode::bad_input,
                "a part of a picture cannot be rendered down to a noise: where enough is done "
                "shows only in the whole",
                {}, "leave 'noise' away, or render the whole picture");
  const auto line = [&](int band) {
    return region.y0 + static_cast<int>(int64_t{lines} * band / share.tiles);
  };
  const int y0 = line(share.tile), y1 = line(share.tile + 1);
  region.y0 = y0, region.y1 = y1;
  State state;
  state.begin = share.begin;
  state.end = end;
  state.film = Film(region, options.layers.gather());
  state.done.assign(region.blocks(State::kBlock), state.begin);
  state.settled.assign(state.done.size(), 0);
  return state;
}

void proceed(const Scene& scene, const Options& options, State& state, const Watch& watch,
             Progress& progress) {
  std::optional<ThreadLimit> limit;
  if (options.threads > 0) limit.emplace(options.threads);
  const Shooter shooter(scene, options, progress);
  if (watch.estimate) watch.estimate(shooter.seconds(static_cast<double>(missing(state))));
  const uint64_t all = all_samples(state);
  progress.begin("rendering", all);
  progress.advance(all - missing(state));
  Work work(shooter, state, watch, progress);
  try {
    for (const Stop& stop : stops(state, options, watch)) {
      // A state that was saved later than this has been looked at here already.
      if (std::any_of(state.done.begin(), state.done.end(),
                      [&](uint32_t done) { return done > stop.count; }))
        continue;
      work.up_to(stop.count);
      if (!stop.look) continue;
      if (options.noise > 0 && stop.count < state.end) {
        const uint64_t needed = missing(state);
        settle(state, options.noise);
        progress.advance(needed - missing(state));
      }
      if (watch.pass) watch.pass(state);
    }
    progress.end();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) work.save();
    throw;
  }
  work.save();
  if (const auto [refused, cut] = state.film.faults(); watch.faults && refused + cut > 0)
    watch.faults(refused, cut);
}

image::Image develop(const State& state, const LayerPlan& layers) {
  image::Image image(state.region().width(), state.region().height(), layers.channels());
  const Region& region = state.region();
  develop(state.film, layers, region, image);
  return image;
}

}  // namespace vug::render
