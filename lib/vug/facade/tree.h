// SPDX-License-Identifier: Apache-2.0
// The result of a facade's derivation: rectangles, splits with their numbers, elements. It is made
// by derivations and samplers and read by everything that is built from facades.
#pragma once

#include <vug/facade/element.h>
#include <vug/facade/split.h>

#include <string>
#include <vector>

namespace vug::facade {

struct Node {
  std::string symbol;  ///< "PartFacade"; the kind for elements and inner splits.
  int parent = -1;     ///< Index in Tree::nodes, less than this node's; -1 for roots.
  std::vector<int> children;
  Rect rect;  ///< On the facade's plane, of the derived occurrence.
  /// Further occurrences within the parent, as placements on the facade's plane.
  std::vector<Placement> copies;
  bool mirrored = false;  ///< The element is mirrored about its vertical centre line.
  double depth = 0;   ///< Distance of its plane in front of the facade's, metres; negative: behind.
  std::string split;  ///< The kind of split that divides it; empty: none, or several.
  Numbers given;      ///< Numbers of its cell in the parent, such as a row's height.
  Numbers numbers;    ///< Numbers of its own split, such as a grid's counts.
  ElementPtr element;  ///< Null if it is divided further.
  std::string text;    ///< The symbol with its arguments: "Bay(2)".
  std::string rule;    ///< The rule that divided it, as text; empty for elements.
  bool stuck = false;  ///< No rule applied.
};

struct Tree {
  std::string name;              ///< Name of the grammar.
  double width = 0, height = 0;  ///< Metres.
  std::vector<Node> nodes;       ///< Parents precede their children; there may be several roots.
};

/// One occurrence of an element with its final rectangle.
struct ElementInstance {
  int node = 0;
  Rect rect;
  bool mirrored = false;
};

/// The number of occurrences of each node, indexed like Tree::nodes. Doubles, because the number of
/// nested copies may exceed the range of integers.
std::vector<double> occurrences(const Tree& tree);

/// The placements of all occurrences of a node; the first is the identity.
std::vector<Placement> placements(const Tree& tree, int node);

/// All occurrences of all elements, in the order of nodes, then of copies. Throws Error(too_large)
/// beyond a million.
std::vector<ElementInstance> element_instances(const Tree& tree);

}  // namespace vug::facade
