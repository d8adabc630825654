// The sampler of facades: proposals a second on one thread, from the full tree of a facade of
// 500 x 700 pixels, with each likelihood. Prints a table.
//   bench_fit [millions of proposals]      default: 2
#include <vug/base/parallel.h>
#include <vug/fit/compile.h>
#include <vug/fit/move.h>
#include <vug/fit/seeds.h>

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>

namespace {

using namespace vug;
using namespace vug::fit;

constexpr int kWidth = 500, kHeight = 700;

/// Five columns and six rows of windows above shops, and noise.
bool is_window(int x, int y) {
  return y < 580 && x % 100 > 29 && x % 100 < 75 && y % 95 > 24 && y % 95 < 80;
}

Evidence evidence(bool supervised) {
  RandomStream stream{RandomKey(1)};
  std::vector<uint32_t> values;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const Look look = is_window(x, y) ? Look::window : y > 590 ? Look::shop : Look::wall;
      uint32_t seen = static_cast<uint32_t>(look);
      if (stream.below(10) == 0) seen = stream.below(kLooks);
      for (uint32_t lane = 0; lane < kLooks; ++lane)
        values.push_back(supervised ? (lane == seen ? 8 : 320) : (lane == seen ? 1 : 0));
    }
  return Evidence(kWidth, kHeight, kLooks, values);
}

void measure(const Rules& rules, const std::string& likelihood, int64_t steps) {
  const bool supervised = likelihood == "supervised";
  const Evidence pixels = evidence(supervised);
  const Model model(rules, {}, kWidth, kHeight, &pixels, make_likelihood(likelihood, pixels));
  const Hints hints = supervised ? Hints::of_looks(pixels) : Hints::of_clusters(pixels);
  const Workshop shop{model, hints};
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<State> found = seeds(shop, pixels, supervised);
  const std::chrono::duration<double> seeding = std::chrono::steady_clock::now() - begin;
  if (found.empty()) return;
  const inference::Moves<State> all = moves(shop);
  inference::Chain<State> chain(
      all, [&](State& state) { return model.energy(state); }, found.front(), RandomKey(1));
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
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 2;
  const vug::ThreadLimit one(1);
  const Rules rules = compile(vug::facade::load_rules(VUG_DATA "/facades/ripperda.vug"));
  for (const LikelihoodKind* kind : likelihood_kinds())
    measure(rules, kind->info.name, static_cast<int64_t>(1e6 * millions));
}
