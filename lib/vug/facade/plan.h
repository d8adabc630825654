// A derivation that is chosen instead of drawn: which rule divides which node, and the numbers that
// its text leaves open. Plain data, shared and immutable: a changed plan shares all but the way to
// the change.
#pragma once

#include <vug/facade/free_numbers.h>

#include <compare>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace vug::facade {

/// Which part of its parent a node is. It stays the same when counts change.
struct PartKey {
  int item = 0;             ///< Among the items of the rule, from 0.
  int part = 0;             ///< Among the parts of the item's split; else 0.
  int column = 0, row = 0;  ///< As in Cell.
  auto operator<=>(const PartKey&) const = default;
};

struct Plan;
using PlanPtr = std::shared_ptr<const Plan>;

/// What is decided of a node.
struct Plan {
  int rule = -1;  ///< Index in Rules::rules; below 0: none divides it yet. Splits inside of splits
                  ///< have none, but numbers and parts of their own.
  /// Of its split; those of a rule's second split have "2." before their names, and so on.
  NumberValues numbers;
  bool apart = false;  ///< What its split would stamp again are nodes of their own.
  /// Columns and rows of its split where nothing stands; what is stamped again stands everywhere.
  std::set<std::pair<int, int>> off;
  std::map<PartKey, PlanPtr> parts;  ///< Missing: nothing is decided.
};

/// What deriving by a plan tells of a node beside the tree.
struct PlannedNode {
  PartKey place;
  PlanPtr plan;                  ///< Null: nothing is decided.
  std::vector<FreeNumber> free;  ///< What its splits leave open, with the numbers as they are.
  bool mirrored = false;         ///< Its own frame runs from the right to the left.
};

}  // namespace vug::facade
