// SPDX-License-Identifier: Apache-2.0
// Inside modeller/ only: operations on plans that several edits share.
#pragma once

#include <vug/modeller/edit.h>

namespace vug::modeller {

/// Error(bad_input) unless the node can be divided by a rule and is not divided yet.
void require_open(const FacadeState& state, int node);
/// Error(bad_input) unless the node is divided by a split or a rule.
void require_divided(const FacadeState& state, int node);

/// A plan with the rule and without parts; names without numbers are left out.
facade::PlanPtr plan_of(int rule, const facade::NumberValues& numbers);

/// The state with the first feasible plan; otherwise throws the InfeasiblePlan of the first.
FacadeState first_feasible(const FacadeState& state, int node,
                           const std::vector<facade::PlanPtr>& plans);

/// The plan with the rule of another symbol that has the same right side; null without one.
/// Arguments and numbers are kept.
facade::PlanPtr translated(const Style& style, const facade::PlanPtr& plan,
                           const std::string& symbol);

/// The state after `plan` at the node, dropping numbers that no longer fit: a rejected list is
/// replaced by its mean, a rejected number is removed. If the rule passes its rectangle on, the
/// numbers are those of its part. Throws InfeasiblePlan if one of `needed` does not fit.
FacadeState with_feasible_numbers(const FacadeState& state, int node, facade::Plan plan,
                                  const facade::NumberValues& needed);

/// Numbers overwritten by `changes`, in which a name without numbers removes that number.
facade::NumberValues merged(facade::NumberValues numbers, const facade::NumberValues& changes);

/// Whether each cell of the node's split is a node of its own.
bool has_cells(const FacadeState& state, int node);

}  // namespace vug::modeller
