// SPDX-License-Identifier: Apache-2.0
// Queries for user interfaces: applicable rules and actions, and the node under the mouse.
#pragma once

#include <vug/modeller/facade_state.h>

#include <optional>

namespace vug::modeller {

/// A rule of the grammar and whether it applies to a node.
struct RuleChoice {
  int rule = -1;  ///< Index in Rules::rules.
  facade::Reason reason = facade::Reason::none;
  std::string why = {}, hint = {};  ///< Sentences; empty if the rule applies.
  std::vector<facade::FreeNumber> free =
      {};                ///< If it applies: its free numbers with their defaults.
  bool applied = false;  ///< It divides the node already; the reason is then `divided`.
};

/// Evaluates the rule with these numbers at a node; the state is not modified.
RuleChoice evaluate_rule(const FacadeState& state, int node, int rule,
                         const facade::NumberValues& numbers = {});
/// All rules of the node's symbol.
std::vector<RuleChoice> choices(const FacadeState& state, int node);
/// All rules of the grammar; those of other symbols are marked as inapplicable.
std::vector<RuleChoice> all_choices(const FacadeState& state, int node);

/// An action with the first of its rules that applies; if none does, the reason of the first.
struct ActionChoice {
  const Action* action = nullptr;
  RuleChoice choice;
};
std::vector<ActionChoice> actions(const FacadeState& state, int node);

/// The node at a point of the facade's plane.
struct Hit {
  int node = 0;  ///< Innermost node.
  /// Which instance was hit: maps the node's own rectangle to the one at the point.
  facade::Placement placement;
  double x = 0, y = 0;  ///< The point in the node's own frame, as used by lines and edits.
};
/// Empty outside of the facade.
std::optional<Hit> hit(const FacadeState& state, double x, double y);

}  // namespace vug::modeller
