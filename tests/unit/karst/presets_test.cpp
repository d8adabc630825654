// SPDX-License-Identifier: Apache-2.0
// The presets resemble real caves: their measures lie between the 10 % and 90 % quantiles.
#include "caves.h"

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/karst/realistic.h>

namespace vug::karst {
namespace {

constexpr size_t kSeeds = 20;
constexpr int kAttempts = 8;

/// For each criterion the number of seeds with a value in the band of real caves.
std::vector<int> seeds_in_bands(const Preset& preset, int attempts) {
  std::vector<network::Realism> realism(kSeeds);
  parallel_for(kSeeds, [&](size_t seed) {
    KarstOptions options = preset.options;
    options.seed = seed + 1;
    realism[seed] = generate_realistic(preset.geology, options, attempts).realism;
  });
  std::vector<int> inside(network::criteria().size(), 0);
  for (const network::Realism& r : realism)
    for (size_t c = 0; c < inside.size(); ++c) inside[c] += r.network[c].realism >= 1;
  return inside;
}

TEST(PresetBands, ChosenNetworksAreInTheBandsOfRealCaves) {
  for (const Preset& preset : presets()) {
    const std::vector<int> inside = seeds_in_bands(preset, kAttempts);
    for (size_t c = 0; c < inside.size(); ++c)
      EXPECT_GE(inside[c], 0.9 * kSeeds) << preset.name << ": " << network::criteria()[c].name;
  }
}

TEST(PresetBands, MostNetworksAreInThemWithoutAChoice) {
  for (const Preset& preset : presets()) {
    const std::vector<int> inside = seeds_in_bands(preset, 1);
    int sum = 0;
    for (const int count : inside) sum += count;
    EXPECT_GE(sum, 0.9 * static_cast<double>(kSeeds * inside.size())) << preset.name;
  }
}

TEST(Realistic, ReturnsTheBestOfItsAttempts) {
  KarstOptions options = small_options();
  const RealisticNetwork one = generate_realistic(small_geology(), options, 1);
  EXPECT_EQ(one.seed, options.seed);
  EXPECT_EQ(digest_of(one.network), digest_of(generate(small_geology(), options)));
  const RealisticNetwork best = generate_realistic(small_geology(), options, 5);
  EXPECT_GE(best.realism.overall, one.realism.overall);
  options.seed = best.seed;
  EXPECT_EQ(digest_of(best.network), digest_of(generate(small_geology(), options)));
  EXPECT_THROW(generate_realistic(small_geology(), options, 0), Error);
}

}  // namespace
}  // namespace vug::karst
