// SPDX-License-Identifier: Apache-2.0
// Derivation of facades: rules are selected as in every grammar, and splits subdivide rectangles.
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
  grammar::Tree derivation;  ///< With the selected rules, for traces.
  Tree tree;
};

/// Options of a derivation with given rules and numbers; see plan.h.
struct PlanOptions {
  Plan plan;         ///< Plan of the facade itself; its parts are those of the axiom.
  double least = 0;  ///< Minimum width and height of parts, metres.
};

struct PlannedDerivation {
  FacadeDerivation derived;
  PlannedNode root;                ///< The facade itself.
  std::vector<PlannedNode> nodes;  ///< Indexed like Tree::nodes.
};

/// Derives a facade. Guards, weights, sizes and arguments are evaluated as expressions of the
/// evaluator's document; `width` and `height` are the scope's size, `index` (0-based) and `total`
/// the position among the split's cells and their number. Returns nothing, with diagnostics, after
/// an error; symbols to which no rule applies are warnings. Throws Error(too_large) beyond the
/// limits.
std::optional<FacadeDerivation> derive(const Rules& rules, scene::Evaluator& evaluator,
                                       const DeriveOptions& options);

/// Derives a facade by a plan. Symbols without a rule remain, marked as stuck. Numbers that the
/// plan does not fix have defaults that depend on the size. Throws InfeasiblePlan if a rule or a
/// number is not possible.
std::optional<PlannedDerivation> derive(const Rules& rules, scene::Evaluator& evaluator,
                                        const DeriveOptions& options, const PlanOptions& planning);

}  // namespace vug::facade
