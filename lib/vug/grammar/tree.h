// A derivation as data: every occurrence with where it came from.
#pragma once

#include <vug/grammar/grammar.h>

namespace vug::grammar {

/// An occurrence of a symbol in a derivation.
struct Node {
  Symbol symbol;
  RandomKey key{0};       ///< The path of names and ordinals as a key; see Tree::path.
  int parent = -1;        ///< Index in Tree::nodes; -1 for the root. Always below the own index.
  int depth = 0;          ///< 0 for the root.
  int64_t ordinal = 0;    ///< Which of the parent's children of that name, from 0.
  int production = -1;    ///< Index in Tree::productions that rewrote it; -1: a leaf.
  bool terminal = false;  ///< Marked so by the part that made it.
  bool stuck = false;     ///< Has productions, but none applied here: kept as it is.
  std::vector<int> children;
};

/// What a tree remembers of a production.
struct ProductionInfo {
  std::string name;
  std::string symbol;
  SourceLocation where;
};

struct Tree {
  std::vector<Node> nodes;  ///< nodes[0] is the root; parents come before their children.
  std::vector<ProductionInfo> productions;
  int64_t applied = 0;  ///< Productions applied; the axiom does not count.

  /// "cave/Room[3]/+[0]": what the node's key is made of, under the derivation's key.
  std::string path(int node) const;
  /// Leaves in depth-first order: the word that was derived.
  std::vector<int> leaves() const;
};

}  // namespace vug::grammar
