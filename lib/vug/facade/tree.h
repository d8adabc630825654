// What a facade's derivation comes to: rectangles, splits with their numbers, elements. Deriving
// makes it, a sampler may, and everything that is made of facades reads it.
#pragma once

#include <vug/facade/element.h>
#include <vug/facade/split.h>

#include <string>
#include <vector>

namespace vug::facade {

struct Node {
  std::string symbol;  ///< "PartFacade"; of an element its kind, of an inner split that split's.
  int parent = -1;     ///< Index in Tree::nodes, below the own; -1 for the first.
  std::vector<int> children;
  Rect rect;  ///< On the facade's plane, of the occurrence that is derived.
  /// Further occurrences within the parent, as motions of the facade's plane.
  std::vector<Placement> copies;
  bool mirrored = false;  ///< The element is turned about its upright middle.
  double depth = 0;       ///< How far its plane lies before the facade's; below 0: behind.
  std::string split;      ///< The kind of split that divides it; empty: none, or several.
  Numbers given;          ///< Of its place in the parent, such as a row's height.
  Numbers numbers;        ///< Of its own split, such as a grid's counts.
  ElementPtr element;     ///< Null where it is divided further.
  std::string text;       ///< The symbol with its arguments: "Bay(2)".
  std::string rule;       ///< What divided it, as text; empty for elements.
  bool stuck = false;     ///< No rule applied.
};

struct Tree {
  std::string name;  ///< Of the grammar.
  double width = 0, height = 0;
  std::vector<Node> nodes;  ///< Parents before their children; several may have no parent.
};

/// One element where it stands.
struct ElementInstance {
  int node = 0;
  Rect rect;
  bool mirrored = false;
};

/// How often each node occurs: 1 for what is not repeated. Index as in Tree::nodes. Doubles, as
/// copies of copies may be too many for integers.
std::vector<double> occurrences(const Tree& tree);

/// All places of a node; the first is its own, neither shifted nor mirrored.
std::vector<Placement> placements(const Tree& tree, int node);

/// Every element at every place, in the order of nodes, then of copies. Error(too_large) beyond a
/// million.
std::vector<ElementInstance> element_instances(const Tree& tree);

}  // namespace vug::facade
