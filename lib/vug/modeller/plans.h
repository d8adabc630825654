// Inside modeller/ only: what several edits do with plans.
#pragma once

#include <vug/modeller/edit.h>

namespace vug::modeller {

/// Error(bad_input) unless a rule of the grammar may divide the node and none does yet.
void require_open(const FacadeState& state, int node);
/// Error(bad_input) unless a split divides the node, or a rule.
void require_divided(const FacadeState& state, int node);

/// A plan with that rule and no parts; names without a number are left out.
facade::PlanPtr plan_of(int rule, const facade::NumberValues& numbers);

/// The state with the first of these that can be followed; InfeasiblePlan as for the first.
FacadeState first_feasible(const FacadeState& state, int node,
                           const std::vector<facade::PlanPtr>& plans);

/// The plan for another symbol: by the rule of that symbol with the same right side; null where
/// there is none. Arguments and numbers are as they were.
facade::PlanPtr translated(const Style& style, const facade::PlanPtr& plan,
                           const std::string& symbol);

/// The state after `plan` at the node, with fewer numbers where they do not fit any more: of those
/// that are refused a list becomes its mean, one number is left out. Where the rule hands its
/// rectangle on, the numbers are those of its part. InfeasiblePlan where one of `needed` does not
/// fit.
FacadeState with_feasible_numbers(const FacadeState& state, int node, facade::Plan plan,
                                  const facade::NumberValues& needed);

/// Both; in `changes` a name without numbers is one to forget.
facade::NumberValues merged(facade::NumberValues numbers, const facade::NumberValues& changes);

/// Whether each cell of the node's split is a node of its own.
bool has_cells(const FacadeState& state, int node);

}  // namespace vug::modeller
