// SPDX-License-Identifier: Apache-2.0
// Networks that are chosen for their realism.
#pragma once

#include <vug/karst/generate.h>
#include <vug/network/score.h>

namespace vug::karst {

inline constexpr int kMostAttempts = 100;

struct RealisticNetwork {
  network::Network network;
  network::Realism realism;
  uint64_t seed = 0;  ///< With which `generate` gives the same network.
};

/// Generates up to `attempts` networks, the first with the seed of the options and the others with
/// seeds derived from it. Returns the first one whose measures all lie between the 10 % and the 90
/// % quantile of real caves, else the one with the highest overall score (the first of several).
/// Throws like generate, and Error(bad_input) unless 1 <= attempts <= kMostAttempts,
/// and Error(too_large) for more than a million samples in all attempts.
RealisticNetwork generate_realistic(const Geology& geology, KarstOptions options, int attempts);

}  // namespace vug::karst
