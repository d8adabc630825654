// SPDX-License-Identifier: Apache-2.0
// Start trees for the chains.
#pragma once

#include <vug/fit/search/parse.h>

namespace vug::fit {

struct SeedOptions {
  /// Rounds in which the appearance of windows is re-estimated from the last tree.
  int rounds = 3;
  int thorough = 2;  ///< Number of estimates that are parsed at full depth.
  ParseOptions parse;
};

/// Good start trees, best first. `supervised` says whether the evidence holds code lengths per
/// RegionType instead of clusters.
std::vector<TreeState> seeds(const MoveContext& context, const Evidence& evidence, bool supervised,
                             const SeedOptions& options = {});

}  // namespace vug::fit
