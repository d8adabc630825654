// What a window asks to draw its buttons and to tell what lies under the mouse.
#pragma once

#include <vug/modeller/facade_state.h>

#include <optional>

namespace vug::modeller {

/// A rule of the grammar as seen from a node.
struct RuleChoice {
  int rule = -1;  ///< Index in Rules::rules.
  facade::Reason reason = facade::Reason::none;
  std::string why = {}, hint = {};  ///< A sentence; empty where it can be applied.
  std::vector<facade::FreeNumber> free =
      {};                ///< Where it can: numbers to tell, as they are by default.
  bool applied = false;  ///< It divides the node; the reason is then `divided`.
};

/// The rule with these numbers at a node, which stays as it is.
RuleChoice evaluate_rule(const FacadeState& state, int node, int rule,
                         const facade::NumberValues& numbers = {});
/// All rules of the node's symbol.
std::vector<RuleChoice> choices(const FacadeState& state, int node);
/// All rules of the grammar: those of other symbols too, marked as such.
std::vector<RuleChoice> all_choices(const FacadeState& state, int node);

/// An action with the first of its rules that can be applied; else with why its first cannot.
struct ActionChoice {
  const Action* action = nullptr;
  RuleChoice choice;
};
std::vector<ActionChoice> actions(const FacadeState& state, int node);

/// What lies at a point of the facade's plane.
struct Hit {
  int node = 0;                 ///< The innermost.
  facade::Placement placement;  ///< Which of its places: from its own to the one at the point.
  double x = 0, y = 0;          ///< The point in the node's own frame, as lines and edits have it.
};
/// Nothing outside of the facade.
std::optional<Hit> hit(const FacadeState& state, double x, double y);

}  // namespace vug::modeller
