// SPDX-License-Identifier: Apache-2.0
// Plans: derivations that are specified instead of random: the rule that divides each node and the
// free numbers of its text. Plain data, shared and immutable: a modified plan shares everything
// except the path to the modification.
#pragma once

#include <vug/facade/free_numbers.h>

#include <compare>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace vug::facade {

/// Identifies a node among the parts of its parent. It does not change when counts change.
struct PartKey {
  int item = 0;             ///< Index among the items of the rule.
  int part = 0;             ///< Index among the parts of the item's split; else 0.
  int column = 0, row = 0;  ///< As in Cell.
  auto operator<=>(const PartKey&) const = default;  // NOLINT(modernize-use-nullptr)
};

struct Plan;
using PlanPtr = std::shared_ptr<const Plan>;

/// The decisions about a node.
struct Plan {
  int rule = -1;  ///< Index in Rules::rules; negative: no rule divides it yet. Splits inside of
                  ///< splits have no rule, but numbers and parts of their own.
  /// Numbers of its split; the names of those of a rule's second split start with "2.", and so on.
  NumberValues numbers;
  bool apart = false;  ///< Copies made by its split become nodes of their own.
  /// Empty cells of its split as (column, row); copied cells cannot be empty.
  std::set<std::pair<int, int>> off;
  std::map<PartKey, PlanPtr> parts;  ///< Missing: no decisions.
};

/// The result of a planned derivation for a node, in addition to the tree.
struct PlannedNode {
  PartKey place;
  PlanPtr plan;                  ///< Null: no decisions.
  std::vector<FreeNumber> free;  ///< The free numbers of its splits with their values.
  bool mirrored = false;         ///< Its frame runs from right to left.
};

}  // namespace vug::facade
