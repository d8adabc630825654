// The one place where a production is chosen and applied; every order of derivation calls it.
#pragma once

#include <vug/grammar/tree.h>

namespace vug::grammar {

/// What rewriting one occurrence gives.
struct Expansion {
  int production = -1;  ///< Index in Grammar::productions; -1: none applied.
  bool stuck = false;   ///< There were candidates by name, but arity, guards or weights forbade.
  std::vector<Node> children;  ///< Without parent index and depth filled in.
};

/// The production for `node` among those whose name and arity fit and whose guards hold, with
/// probability proportional to weight, applied. `room` bounds the number of children. Throws
/// Error(bad_input) for bad weights and counts, Error(too_large) beyond `room`.
Expansion expand(const Grammar& grammar, const Node& node, int64_t room);

/// The axiom, as the expansion of the root.
Expansion expand_axiom(const Grammar& grammar, const Node& root, int64_t room);

}  // namespace vug::grammar
