// SPDX-License-Identifier: Apache-2.0
// The sampler of facades on a facade of 500 x 700 pixels: proposals per second on one thread, from
// the full tree, with each likelihood; then the guarantees for whole searches: the duration of
// eight chains, and the time until a tree is as good as the final one. Prints a table, and a line
// for each guarantee.
//   bench_fit [millions of proposals, 1 without] [photos]
//
// Chains are timed in processor seconds, which on a busy machine are an upper bound for an idle
// one; searches are timed in wall-clock seconds, because parts of a search are serial.
#include <vug/base/parallel.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/evidence/working_size.h>
#include <vug/fit/fit_facade.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/move.h>
#include <vug/fit/search/sampler.h>
#include <vug/fit/search/seeds.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <thread>

namespace {

using namespace vug;
using namespace vug::fit;

constexpr int kWidth = 500, kHeight = 700;

/// Five columns and six rows of windows above shops, with noise.
bool is_window(int x, int y) {
  return y < 580 && x % 100 > 29 && x % 100 < 75 && y % 95 > 24 && y % 95 < 80;
}

Evidence evidence(bool supervised) {
  RandomStream stream{RandomKey(1)};
  std::vector<uint32_t> values;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const RegionType type = is_window(x, y) ? RegionType::window
                              : y > 590       ? RegionType::shop
                                              : RegionType::wall;
      uint32_t seen = static_cast<uint32_t>(type);
      if (stream.below(10) == 0) seen = stream.below(kRegionTypes);
      for (uint32_t lane = 0; lane < kRegionTypes; ++lane)
        values.push_back(supervised ? (lane == seen ? 8 : 320) : (lane == seen ? 1 : 0));
    }
  return Evidence(kWidth, kHeight, kRegionTypes, values);
}

/// Millions of proposals per second.
double measure(const Rules& rules, const std::string& likelihood, int64_t steps) {
  const bool supervised = likelihood == "supervised";
  const Evidence pixels = evidence(supervised);
  const Model model(rules, {}, kWidth, kHeight, {&pixels, make_likelihood(likelihood, pixels)});
  const EdgeHints hints =
      supervised ? EdgeHints::from_supervised(pixels) : EdgeHints::from_clusters(pixels);
  const MoveContext context{model, hints};
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<TreeState> found = seeds(context, pixels, supervised);
  const std::chrono::duration<double> seeding = std::chrono::steady_clock::now() - begin;
  if (found.empty()) return 0;
  const inference::Moves<TreeState> all = moves(context);
  inference::Chain<TreeState> chain(
      all, [&](TreeState& state) { return model.energy(state); }, found.front(), RandomKey(1));
  const std::clock_t used = std::clock();
  for (int64_t i = 0; i < steps; ++i) chain.step();
  const double seconds = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC;
  int64_t possible = 0, accepted = 0;
  for (const inference::MoveCount& count : chain.counts())
    possible += count.possible, accepted += count.accepted;
  fmt::print(
      "{:12} {:5} nodes  {:5.2f} M proposals/s  {:4.1f} % possible  {:4.1f} % accepted  "
      "seeds in {:.2f} s\n",
      likelihood, chain.state().tree.size(), 1e-6 * static_cast<double>(steps) / seconds,
      100.0 * static_cast<double>(possible) / static_cast<double>(steps),
      100.0 * static_cast<double>(accepted) / static_cast<double>(steps), seeding.count());
  return 1e-6 * static_cast<double>(steps) / seconds;
}

constexpr int kCores = 2;
constexpr double kRate = 0.5;        ///< Millions of proposals per second and thread.
constexpr double kChains = 15;       ///< Seconds for 8 chains of 1 M proposals on two cores.
constexpr double kUsable = 3;        ///< Seconds until a tree is usable, i.e. its
constexpr double kTolerance = 0.02;  ///< bits exceed those of the final one by this share.

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

const char* verdict(bool kept) { return kept ? "kept" : "MISSED"; }

/// Eight chains from the best seed, on two threads.
void measure_chains(const Rules& rules, double millions) {
  with_threads(kCores, [&] {
    const Evidence pixels = evidence(false);
    const Model model(rules, {}, kWidth, kHeight, {&pixels, make_likelihood("kt", pixels)});
    const EdgeHints hints = EdgeHints::from_clusters(pixels);
    const MoveContext context{model, hints};
    const std::vector<TreeState> found = seeds(context, pixels, false);
    SamplerOptions options;
    options.steps = static_cast<int64_t>(1e6 * millions);
    const double begin = processor_seconds();
    sample(context, options, RandomKey(1), Progress::none(), {found.front()});
    const double used = (processor_seconds() - begin) / millions;
    fmt::print(
        "8 chains of 1 M proposals: {:.1f} s of the processor, {:.1f} s on {} cores ({} s: {})\n",
        used, used / kCores, kCores, kChains, verdict(used / kCores <= kChains));
  });
}

struct Search {
  double bits = 0;                    ///< Description length of its tree.
  double seconds = 0, processor = 0;  ///< Wall-clock seconds, and CPU seconds of all threads.
};

/// A search that stops after `stop` seconds; 0: never.
Search search(const Rules& rules, const Evidence& pixels, double stop) {
  using Clock = std::chrono::steady_clock;
  Progress progress;
  const double used = processor_seconds();
  const auto begin = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  std::atomic<bool> done = stop <= 0;
  std::thread clock([&] {
    while (!done && passed() < stop) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!done) progress.cancel();
  });
  const double bits = fit_facade(pixels, rules, {}, RandomKey(1), progress).report.bits;
  const double seconds = passed();
  done = true;
  clock.join();
  return {bits, seconds, processor_seconds() - used};
}

void measure_usable(const Rules& rules, const std::string& name, const Evidence& pixels) {
  constexpr double kEarly = 0.8;  // share of the time, because steps in progress are completed
  with_threads(kCores, [&] {
    const Search whole = search(rules, pixels, 0), early = search(rules, pixels, kEarly * kUsable);
    const double more = early.bits / whole.bits - 1;
    fmt::print(
        "{}: {:.0f} bits after {:.1f} s ({:.1f} of the processor), {:.2f} % more after {:.1f} s "
        "({:.1f}) ({} % in {} s: {})\n",
        name, whole.bits, whole.seconds, whole.processor, 100 * more, early.seconds,
        early.processor, 100 * kTolerance, kUsable,
        verdict(more <= kTolerance && early.seconds <= kUsable));
  });
}

/// The evidence of all pixels of a photo, from their colours.
Evidence evidence_of(const std::string& photo) {
  const image::Image colours = read_photo(photo);
  return cluster_image(&colours, nullptr, {}, RandomKey(1)).evidence();
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 1;
  const Rules rules = compile(vug::facade::load_rules(VUG_DATA "/facades/ripperda.vug"));
  double least = INFINITY;
  {
    vug::with_threads(1, [&] {
      for (const LikelihoodKind* kind : likelihood_kinds())
        least =
            std::min(least, measure(rules, kind->info.name, static_cast<int64_t>(1e6 * millions)));
    });
  }
  fmt::print("the slowest: {:.2f} M proposals/s on a thread ({}: {}); librjmcmc: 3.2 on circles\n",
             least, kRate, verdict(least >= kRate));
  measure_chains(rules, millions);
  measure_usable(rules, "made up", evidence(false));
  for (int i = 2; i < argc; ++i) measure_usable(rules, argv[i], evidence_of(argv[i]));
}
