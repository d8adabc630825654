// Trees to begin with.
#pragma once

#include <vug/fit/search/parse.h>

namespace vug::fit {

struct SeedOptions {
  int rounds = 3;    ///< In each what windows look like is learnt anew from the last tree.
  int thorough = 2;  ///< How many of what was learnt are looked at in full depth.
  ParseOptions parse;
};

/// Trees that are worth to begin with, the best first. `of_looks` says what the lanes of the
/// evidence are.
std::vector<TreeState> seeds(const MoveContext& context, const Evidence& evidence, bool supervised,
                             const SeedOptions& options = {});

}  // namespace vug::fit
