// Derivations: one occurrence after the other, depth first, or all at once in generations.
//
// Random choice is keyed by path: an occurrence's key is its parent's key, its own name and its
// ordinal among its parent's children of that name. So a branch keeps its bytes whatever happens
// in other branches, more repetitions leave the earlier ones as they were, and both orders of
// derivation, on any number of threads, give the same tree.
#pragma once

#include <vug/base/progress.h>
#include <vug/grammar/tree.h>

namespace vug::grammar {

/// Where a derivation that does not end is stopped: Error(too_large) naming symbol and limit.
struct Limits {
  int64_t productions = 1'000'000;  ///< Productions applied.
  int64_t symbols = 4'000'000;      ///< Occurrences in the tree.
};

/// Rewrites depth first, leftmost first, until nothing can be rewritten. `visit` (may be null)
/// is called for every finished leaf in that order, so that guards may look at what the leaves
/// so far have built; it sees the unfinished tree and may keep no reference to it. In the result
/// nodes are numbered in depth-first order.
Tree derive(const Grammar& grammar, RandomKey key, const Limits& limits = {},
            const std::function<void(const Tree&, int)>& visit = {},
            Progress& progress = Progress::none());

/// Rewrites all occurrences of a generation at once (as L-systems do), `generations` times or,
/// when negative, until nothing can be rewritten. What is left over stays as leaves. Nodes are
/// numbered generation by generation.
Tree derive_parallel(const Grammar& grammar, RandomKey key, int generations = -1,
                     const Limits& limits = {}, Progress& progress = Progress::none());

}  // namespace vug::grammar
