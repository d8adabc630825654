// SPDX-License-Identifier: Apache-2.0
// Round trip: random facades of the published grammar are painted, degraded with noise and fitted.
#include "random_facade.h"

#include <vug/base/median.h>
#include <vug/fit/polish/polish.h>

#include <gtest/gtest.h>

#include <numeric>

namespace vug::fit {
namespace {

FitOptions short_chain() {
  FitOptions options;
  options.sampler.steps = 2000;
  options.runs = 1;
  return options;
}

Model model_of(const RandomFacade& facade, const Evidence& pixels) {
  return Model(ripperda(), short_chain().limits, facade.width, facade.height,
               {&pixels, make_likelihood("kt", pixels), short_chain().pixel_weight});
}

/// Many trees draw the same picture. The reference is the shortest known tree of the noise-free
/// picture: the derived one, with each grid changed to the cheapest type that draws the same, or a
/// shorter one found by fitting.
Tree shortest(const RandomFacade& facade) {
  const Evidence clean =
      Evidence::from_clusters(facade.width, facade.height, RandomFacade::kClasses, facade.classes);
  const Model model = model_of(facade, clean);
  const EdgeHints hints = EdgeHints::from_clusters(clean);
  TreeState derived = model.make_state(facade.tree);
  const double bits = polish({model, hints}, clean, derived).after;
  const FitResult found = fit_facade(clean, ripperda(), short_chain(), RandomKey(2));
  return found.report.bits < bits - 1e-6 ? found.tree : derived.tree;
}

std::vector<Rect> windows_of(const Model& model, const Tree& tree) {
  std::vector<Rect> out;
  TreeState state = model.make_state(tree);
  EXPECT_TRUE(std::isfinite(model.energy(state)));
  model.each_terminal(state, [&](RegionType, int, const Rect& r) { out.push_back(r); });
  return out;
}

TEST(ClosedLoop, CountsStructuresAndEdgesAreRecovered) {
  constexpr int kFacades = 30;
  int read_back = 0, counts = 0, structures = 0;
  std::vector<double> off;
  for (uint64_t seed = 1; read_back < kFacades; ++seed) {
    ASSERT_LT(seed, 500u);
    const auto facade = random_facade(seed);
    if (!facade) continue;
    ++read_back;
    const Evidence pixels =
        Evidence::from_clusters(facade->width, facade->height, RandomFacade::kClasses,
                                facade->noisy(0.05, RandomKey(77).at(seed)));
    const Tree truth = shortest(*facade);
    const FitResult found = fit_facade(pixels, ripperda(), short_chain(), RandomKey(1));
    const Model model = model_of(*facade, pixels);
    const EdgeHints hints = EdgeHints::from_clusters(pixels);
    TreeState best = model.make_state(truth);
    const double bits = polish({model, hints}, pixels, best).after;
    // Trees of the same length are equally right.
    const bool tie = std::fabs(found.report.bits - bits) < 0.05;
    structures += tie || found.report.structure == structure_of(ripperda(), truth) ? 1 : 0;
    const std::vector<Rect> windows = windows_of(model, truth);
    counts += windows.size() == found.elements.size() ? 1 : 0;
    for (const Rect& r : windows) {
      double nearest = 1e9;
      for (const DetectedElement& one : found.elements)
        nearest = std::min<double>(
            nearest, std::max({std::abs(one.rect.x0 - r.x0), std::abs(one.rect.x1 - r.x1),
                               std::abs(one.rect.y0 - r.y0), std::abs(one.rect.y1 - r.y1)}));
      off.push_back(nearest);
    }
  }
  EXPECT_GE(counts, 29) << "of " << kFacades;
  EXPECT_GE(structures, 24) << "of " << kFacades;
  EXPECT_LE(median(off), 2) << "pixels";
}

TEST(ClosedLoop, ChainsWithOtherSeedsFindTheSameTree) {
  const auto facade = random_facade(5);
  ASSERT_TRUE(facade);
  const Evidence pixels = Evidence::from_clusters(
      facade->width, facade->height, RandomFacade::kClasses, facade->noisy(0.2, RandomKey(3)));
  FitOptions options = short_chain();
  options.sampler.steps = 20'000;
  std::vector<FitResult> found;
  double least = 1e300;
  std::vector<double> rates(7, 0);  // For each pair of neighbours, over all seeds.
  for (uint64_t key = 0; key < 10; ++key) {
    found.push_back(fit_facade(pixels, ripperda(), options, RandomKey(key)));
    least = std::min(least, found.back().report.bits);
    ASSERT_EQ(found.back().report.swap_rates.size(), rates.size());
    for (size_t pair = 0; pair < rates.size(); ++pair)
      rates[pair] += found.back().report.swap_rates[pair] / 10;
  }
  int same = 0;
  for (const FitResult& one : found)
    same += one.report.bits < least + 3 && one.report.structure == found[0].report.structure;
  EXPECT_GE(same, 9);
  const double mean = std::accumulate(rates.begin(), rates.end(), 0.0) / 7;
  EXPECT_GT(mean, 0.2);
  EXPECT_LT(mean, 0.6);
  for (const double rate : rates) {
    EXPECT_GT(rate, 0.15) << "the error with so few rounds is 0.03";
    EXPECT_LT(rate, 0.65);
  }
}

}  // namespace
}  // namespace vug::fit
