// SPDX-License-Identifier: Apache-2.0
// Derivation trees: all occurrences of symbols with their provenance.
#pragma once

#include <vug/grammar/grammar.h>

namespace vug::grammar {

/// An occurrence of a symbol in a derivation.
struct Node {
  Symbol symbol;
  RandomKey key{0};       ///< The path of names and ordinals as a key; see Tree::path.
  int parent = -1;        ///< Index in Tree::nodes, less than this node's; -1 for the root.
  int depth = 0;          ///< 0 for the root.
  int64_t ordinal = 0;    ///< Index among the parent's children of that name.
  int production = -1;    ///< Index in Tree::productions of the applied production; -1: a leaf.
  bool terminal = false;  ///< Marked as terminal by its SuccessorItem.
  bool stuck = false;     ///< Productions exist, but none applies: the symbol is kept.
  std::vector<int> children;
};

/// The description of a production in a tree.
struct ProductionInfo {
  std::string name;
  std::string symbol;
  SourceLocation where;
};

struct Tree {
  std::vector<Node> nodes;  ///< nodes[0] is the root; parents precede their children.
  std::vector<ProductionInfo> productions;
  int64_t applied = 0;  ///< Number of applied productions, without the axiom.

  /// E.g. "cave/Room[3]/+[0]": the path from which the node's key is derived.
  std::string path(int node) const;
  /// Leaves in depth-first order: the derived word.
  std::vector<int> leaves() const;
};

}  // namespace vug::grammar
