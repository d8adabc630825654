// Inside facade/ only: what a symbol of a facade carries while it is derived.
#pragma once

#include <vug/facade/plan.h>
#include <vug/facade/tree.h>
#include <vug/grammar/tree.h>

#include <memory>

namespace vug::facade {

struct Scope {
  Rect rect;                      ///< On the facade's plane.
  std::vector<Placement> copies;  ///< On the facade's plane.
  Numbers given;
  double depth = 0;  ///< As in Node.
  double index = 0, total = 1;
  bool mirrored = false;  ///< Its frame runs from the right to the left.
  PartKey place;
  PlanPtr plan;                          ///< Null: nothing is decided.
  RandomKey key{0};                      ///< Of this occurrence.
  ElementPtr element;                    ///< Null for symbols.
  std::shared_ptr<const Layout> layout;  ///< Of the split that placed it; null: the whole scope.
  std::string split;                     ///< That split's kind.
};

/// The rectangles of a derivation whose symbols carry scopes, without its size. Node i of the
/// derivation becomes node i - 1: the root is left out.
Tree tree_of(const grammar::Tree& derivation);

}  // namespace vug::facade
