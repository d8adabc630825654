// SPDX-License-Identifier: Apache-2.0
// Text output of `vug facade model`.
#pragma once

#include <vug/modeller/facade_state.h>

#include <string>

namespace vug::cli {

/// One line per node: its path, its rectangle and the rule that divides it.
std::string tree_text(const modeller::FacadeState& state);

/// Lists the rules of one node, or, for ".", of all divided and open nodes: + rules that can be
/// applied with their free numbers, * the rule that divides the node, - other rules with the
/// reason. Also lists the lines that can be moved and, for one node, the actions of the paper's
/// modeller.
std::string list_text(const modeller::FacadeState& state, const std::string& path);

}  // namespace vug::cli
