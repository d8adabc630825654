// Deriving a facade: rules are chosen as in every grammar, splits hand the rectangles on.
#pragma once

#include <vug/facade/plan.h>
#include <vug/facade/rules.h>
#include <vug/facade/tree.h>
#include <vug/grammar/derive.h>
#include <vug/scene/evaluator.h>

#include <optional>

namespace vug::facade {

struct DeriveOptions {
  double width = 12;  ///< Metres.
  double height = 9;
  grammar::Limits limits{100'000, 1'000'000};
  RandomKey key{0};
};

struct FacadeDerivation {
  grammar::Tree derivation;  ///< With the rules that were chosen, for traces.
  Tree tree;
};

/// A derivation whose rules and numbers are chosen; see plan.h.
struct PlanOptions {
  Plan plan;         ///< Of the facade itself; its parts are those of the axiom.
  double least = 0;  ///< Metres; no part is narrower or lower.
};

struct PlannedDerivation {
  FacadeDerivation derived;
  PlannedNode root;                ///< Of the facade itself.
  std::vector<PlannedNode> nodes;  ///< Index as in Tree::nodes.
};

/// Guards, weights, sizes and arguments are evaluated as expressions of the evaluator's document,
/// in which `width` and `height` are the scope's, `index` and `total` say which of how many places
/// of its split a symbol has. Faults go to the evaluator's diagnostics, and then nothing is
/// derived; symbols that no rule applies to are warnings. Error(too_large) beyond the limits.
std::optional<FacadeDerivation> derive(const Rules& rules, scene::Evaluator& evaluator,
                                       const DeriveOptions& options);

/// The same with chosen rules and numbers: symbols without a rule stay as they are, stuck. Numbers
/// that are not told are what is usual for the size. InfeasiblePlan where a rule or a number cannot
/// be had.
std::optional<PlannedDerivation> derive(const Rules& rules, scene::Evaluator& evaluator,
                                        const DeriveOptions& options, const PlanOptions& planning);

}  // namespace vug::facade
