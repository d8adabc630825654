// SPDX-License-Identifier: Apache-2.0
// Selection and application of a production, shared by all orders of derivation.
#pragma once

#include <vug/grammar/tree.h>

namespace vug::grammar {

/// The result of rewriting one occurrence.
struct Expansion {
  int production = -1;  ///< Index in Grammar::productions; -1: none applied.
  bool stuck =
      false;  ///< Productions of that name exist, but arity, guards or weights exclude them.
  std::vector<Node> children;  ///< Parent index and depth are not set.
};

/// Selects a production for `node` among those with matching name and arity whose guards hold, with
/// a probability proportional to its weight, and applies it. `room` is the maximum number of
/// children. Throws Error(bad_input) for invalid weights and counts, Error(too_large) beyond
/// `room`.
Expansion expand(const Grammar& grammar, const Node& node, int64_t room);

/// Expands the root into the axiom.
Expansion expand_axiom(const Grammar& grammar, const Node& root, int64_t room);

}  // namespace vug::grammar
