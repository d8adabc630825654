// SPDX-License-Identifier: Apache-2.0
// Seeds and chains on pictures with known windows.
#include "enumeration.h"

#include <vug/base/parallel.h>
#include <vug/fit/search/sampler.h>
#include <vug/fit/search/seeds.h>
#include <vug/fit/search/segments.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::fit {
namespace {

/// Largest gain of segments from position `from` on, by exhaustive search.
double brute_force(const std::vector<double>& before, const SegmentLimits& limits, int from,
                   int left) {
  double best = 0;
  const auto places = static_cast<int>(before.size()) - 1;
  for (int start = from; left > 0 && start < places; ++start)
    for (int size = limits.min_size; size <= limits.max_size && start + size <= places; ++size)
      best = std::max(best, before[static_cast<size_t>(start + size)] -
                                before[static_cast<size_t>(start)] - limits.cost +
                                brute_force(before, limits, start + size + 1, left - 1));
  return best;
}

TEST(Segments, MatchExhaustiveSearch) {
  RandomStream stream{RandomKey(3)};
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> before = {0};
    for (int i = 0; i < 12; ++i) before.push_back(before.back() + stream.uniform(-2, 2));
    const SegmentLimits limits{1 + trial % 2, 4, 1 + trial % 3, 0.3};
    double gain = 0;
    int free = 0;
    for (const Segment& segment : best_segments(before, limits)) {
      EXPECT_GE(segment.start, free);
      EXPECT_GE(segment.size(), limits.min_size);
      EXPECT_LE(segment.size(), limits.max_size);
      free = segment.end + 1;
      gain += before[static_cast<size_t>(segment.end)] -
              before[static_cast<size_t>(segment.start)] - limits.cost;
    }
    EXPECT_NEAR(gain, brute_force(before, limits, 0, limits.max_count), 1e-12) << trial;
  }
}

TEST(Segments, EmptyIfNothingGains) {
  EXPECT_TRUE(best_segments({0, -1, -2, -3}, {1, 3, 4, 0}).empty());
  EXPECT_TRUE(best_segments({0}, {1, 3, 4, 0}).empty());
}

constexpr int kSeedWidth = 90, kSeedHeight = 80;

/// Windows of two widths in four columns and three rows above a wall, one of them bricked up.
bool is_window_seed(int x, int y) {
  const int lefts[] = {8, 28, 50, 70}, widths[] = {10, 14, 10, 14}, tops[] = {6, 28, 50};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      if (x >= lefts[column] && x < lefts[column] + widths[column] && y >= tops[row] &&
          y < tops[row] + 15)
        return column != 2 || row != 1;
  return false;
}

std::vector<uint8_t> noisy_picture(double noise) {
  RandomStream stream{RandomKey(6)};
  std::vector<uint8_t> out;
  for (int y = 0; y < kSeedHeight; ++y)
    for (int x = 0; x < kSeedWidth; ++x) {
      const bool odd = stream.uniform() < noise;
      out.push_back(static_cast<uint8_t>(odd ? stream.below(3) : is_window_seed(x, y) ? 1 : 0));
    }
  return out;
}

Rules some_rules() {
  return rules_of({"Facade rows Row Part", "Facade grid Grid", "Facade grid IdenticalGrid",
                   "Part grid Grid", "Part grid IdenticalGrid", "Facade mirror Side",
                   "Side grid IdenticalGrid", "Row elements Element", "Element terminal Door",
                   "Grid windows Window", "Grid windows Window Door",
                   "IdenticalGrid windows Window"});
}

/// Intersection over union of detected and true window pixels.
double overlap(const Model& model, const TreeState& state) {
  std::vector<bool> seen(kSeedWidth * kSeedHeight, false);
  model.each_terminal(state, [&](RegionType type, int, const Rect& r) {
    for (int y = r.y0; type == RegionType::window && y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x) seen[static_cast<size_t>(y * kSeedWidth + x)] = true;
  });
  double both = 0, either = 0;
  for (int y = 0; y < kSeedHeight; ++y)
    for (int x = 0; x < kSeedWidth; ++x) {
      const bool a = seen[static_cast<size_t>(y * kSeedWidth + x)], b = is_window_seed(x, y);
      both += a && b ? 1 : 0, either += a || b ? 1 : 0;
    }
  return both / either;
}

/// Noisy clusters of windows and wall, and everything that chains need.
struct Site {
  explicit Site(double noise)
      : evidence(Evidence::from_clusters(kSeedWidth, kSeedHeight, 3, noisy_picture(noise))) {}
  const Evidence evidence;
  const Rules rules = some_rules();
  const Model model{
      rules, {}, kSeedWidth, kSeedHeight, {&evidence, make_likelihood("kt", evidence)}};
  const EdgeHints hints = EdgeHints::from_clusters(evidence);
  const MoveContext context{model, hints};
};

TEST(Seeds, FindColumnsAndRowsOfDifferentSizes) {
  const Site site(0.2);
  const std::vector<TreeState> found = seeds(site.context, site.evidence, false);
  ASSERT_FALSE(found.empty());
  EXPECT_GT(overlap(site.model, found.front()), 0.95);
  double last = 0;
  for (TreeState state : found) {
    const double bits = site.model.energy(state);
    EXPECT_TRUE(std::isfinite(bits));
    EXPECT_GE(bits, last) << "best first";
    last = bits;
  }
}

TEST(Sampler, RecoversFromAPerturbedSeed) {
  const Site site(0.2);
  TreeState best = seeds(site.context, site.evidence, false).front(), seed = best;
  for (int column = 0; column < 4; ++column)  // Shifts windows by a few pixels.
    seed.tree[1].left[static_cast<size_t>(column)] = static_cast<int16_t>(
        seed.tree[1].left[static_cast<size_t>(column)] + (column % 2 ? 3 : -2));
  seed.invalidate_bits(1);
  ASSERT_GT(site.model.energy(seed), site.model.energy(best) + 100);
  SamplerOptions options;
  options.steps = 30'000;
  options.annealing = 3;
  const SamplerResult found = sample(site.context, options, RandomKey(1), Progress::none(), {seed});
  EXPECT_LE(found.bits, site.model.energy(best) + 1e-6);
  EXPECT_GT(overlap(site.model, found.best), 0.95);
  EXPECT_EQ(found.swaps.size(), static_cast<size_t>(options.chains) - 1);
  ASSERT_FALSE(found.structures.empty());
  EXPECT_EQ(found.structures.front().text.substr(0, 7), "Facade(");
}

TEST(Sampler, ResultDoesNotDependOnThreads) {
  const Site site(0.3);
  SamplerOptions options;
  options.steps = 3'000;
  std::vector<double> bits;
  Tree first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const SamplerResult found = sample(site.context, options, RandomKey(1));
      bits.push_back(found.bits);
      if (threads == 1) first = found.best.tree;
      EXPECT_TRUE(found.best.tree == first);
    });
  }
  EXPECT_EQ(bits[0], bits[1]);
  EXPECT_EQ(bits[0], bits[2]);
}

TEST(Sampler, CancelledRunReturnsTheBestSoFar) {
  const Site site(0.2);
  Progress progress;
  progress.cancel();
  const TreeState seed = seeds(site.context, site.evidence, false).front();
  const SamplerResult found = sample(site.context, {}, RandomKey(1), progress, {seed});
  EXPECT_TRUE(found.stopped);
  EXPECT_TRUE(found.best.tree == seed.tree);
}

}  // namespace
}  // namespace vug::fit
