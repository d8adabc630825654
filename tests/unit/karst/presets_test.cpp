// SPDX-License-Identifier: Apache-2.0
// The presets resemble real caves: their measures lie between the 10 % and 90 % quantiles.
#include "caves.h"

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/karst/realistic.h>

#include <algorithm>
#include <cstdlib>

namespace vug::karst {
namespace {

constexpr int kAttempts = 8;

/// VUG_PRESET_SEEDS=50 tests fifty seeds of each preset.
size_t seeds() {
  const char* text = std::getenv("VUG_PRESET_SEEDS");
  return text ? static_cast<size_t>(std::max(1, std::atoi(text))) : 20;
}

/// A network of a seed, and the one that is chosen of several attempts, of which it is the first.
struct Caves {
  network::Realism first;
  network::Realism chosen;
};

std::vector<Caves> caves_of(const Preset& preset) {
  std::vector<Caves> caves(seeds());
  parallel_for(caves.size(), [&](size_t seed) {
    KarstOptions options = preset.options;
    options.seed = seed + 1;
    Caves& here = caves[seed];
    here.chosen = here.first = generate_realistic(preset.geology, options, 1).realism;
    const bool chosen =
        std::all_of(here.first.network.begin(), here.first.network.end(),
                    [](const network::CriterionScore& s) { return s.realism >= 1; });
    if (!chosen) here.chosen = generate_realistic(preset.geology, options, kAttempts).realism;
  });
  return caves;
}

TEST(PresetBands, NetworksAreInTheBandsOfRealCaves) {
  for (const Preset& preset : presets()) {
    const std::vector<Caves> caves = caves_of(preset);
    const size_t criteria = network::criteria().size();
    size_t first = 0;
    for (size_t c = 0; c < criteria; ++c) {
      size_t chosen = 0;
      for (const Caves& cave : caves) {
        first += cave.first.network[c].realism >= 1;
        chosen += cave.chosen.network[c].realism >= 1;
      }
      EXPECT_GE(static_cast<double>(chosen), 0.9 * static_cast<double>(caves.size()))
          << preset.name << ": " << network::criteria()[c].name;
    }
    // Most are even without a choice.
    EXPECT_GE(static_cast<double>(first), 0.9 * static_cast<double>(caves.size() * criteria))
        << preset.name;
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
  EXPECT_THROW(generate_realistic(small_geology(), options, kMostAttempts + 1), Error);
  options.samples.count = 150000;
  EXPECT_THROW(generate_realistic(small_geology(), options, 8), Error);
}

}  // namespace
}  // namespace vug::karst
