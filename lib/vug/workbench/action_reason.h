// SPDX-License-Identifier: Apache-2.0
// Explanations of rules that cannot be applied, for tooltips and the status bar.
#pragma once

#include <vug/modeller/edit.h>
#include <vug/modeller/query.h>

#include <string>

namespace vug::workbench {

/// A sentence with the reason and the remedy; empty if the rule can be applied.
std::string reason_text(const modeller::RuleChoice& choice);

/// The first word of an action's name without its arguments: "rows" of "rows(FacadeRow, ...)".
std::string first_word(const std::string& name);

/// The edit that performs an action with its defaults: one that `actions` lists.
modeller::Edit action_edit(const modeller::FacadeState& state, int node,
                           const modeller::Action& action);

}  // namespace vug::workbench
