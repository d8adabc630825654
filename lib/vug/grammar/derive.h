// SPDX-License-Identifier: Apache-2.0
// Derivation of grammars within limits: sequentially, depth first, or in parallel, generation by
// generation.
//
// Random choices are keyed by path: an occurrence's key is derived from its parent's key, its own
// name and its ordinal among its parent's children of that name. Therefore a branch does not depend
// on other branches, additional repetitions do not change earlier ones, and both orders of
// derivation, on any number of threads, give the same tree.
#pragma once

#include <vug/base/progress.h>
#include <vug/grammar/tree.h>

namespace vug::grammar {

/// Limits that stop a non-terminating derivation with Error(too_large), which names symbol and
/// limit.
struct Limits {
  int64_t productions = 1'000'000;  ///< Productions applied.
  int64_t symbols = 4'000'000;      ///< Occurrences in the tree.
};

/// Rewrites depth first, leftmost first, until no production applies. `visit` (may be null) is
/// called for every finished leaf in that order, so that guards can depend on the geometry of
/// previous leaves. It receives the unfinished tree and must not keep a reference to it. The nodes
/// of the result are numbered in depth-first order.
Tree derive(const Grammar& grammar, RandomKey key, const Limits& limits = {},
            const std::function<void(const Tree&, int)>& visit = {},
            Progress& progress = Progress::none());

/// Rewrites all occurrences of a generation at once (as L-systems do), `generations` times or, if
/// negative, until no production applies. Remaining symbols become leaves. Nodes are numbered
/// generation by generation.
Tree derive_parallel(const Grammar& grammar, RandomKey key, int generations = -1,
                     const Limits& limits = {}, Progress& progress = Progress::none());

}  // namespace vug::grammar
