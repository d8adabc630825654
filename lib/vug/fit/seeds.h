// Trees to begin with: grids whose columns and rows are found by dynamic programming in turn.
#pragma once

#include <vug/fit/move.h>

namespace vug::fit {

/// Bits that a pixel saves, lane by lane, when it is a window's rather than the wall's.
using Gains = std::array<double, kMostLanes>;

/// Of supervised evidence.
Gains gains_of_looks();
/// Of clusters, from how the pixels of windows and wall of a tree are spread over them.
Gains gains_of_regions(const Sums& windows, const Sums& wall, int lanes);

struct SeedOptions {
  int floors = 12;  ///< Heights of the ground floor that are tried, beside none.
  int rounds = 6;   ///< Turns of columns and rows.
};

/// Trees that are worth to begin with, the best first: of each grid type, with and without a
/// ground floor. `supervised` says what the lanes of the evidence are.
std::vector<State> seeds(const Workshop& shop, const Evidence& evidence, bool supervised,
                         const SeedOptions& options = {});

}  // namespace vug::fit
