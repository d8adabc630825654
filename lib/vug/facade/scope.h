// SPDX-License-Identifier: Apache-2.0
// Internal to facade/: the payload of a facade's symbols during the derivation.
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
  double depth = 0;  ///< As Node::depth.
  double index = 0, total = 1;
  bool mirrored = false;  ///< Its frame runs from right to left.
  PartKey place;
  PlanPtr plan;                          ///< Null: no decisions.
  RandomKey key{0};                      ///< Key of this occurrence.
  ElementPtr element;                    ///< Null for symbols.
  std::shared_ptr<const Layout> layout;  ///< Layout of its parent split; null: the whole scope.
  std::string split;                     ///< The kind of that split.
};

/// Converts a derivation whose payloads are scopes into a tree of rectangles without its total
/// size. Node i of the derivation becomes node i - 1, as the root is omitted.
Tree tree_of(const grammar::Tree& derivation);

}  // namespace vug::facade
