// What `vug facade model` prints of a state.
#pragma once

#include <vug/modeller/facade_state.h>

#include <string>

namespace vug::cli {

/// A line for each node: its path, its rectangle, what divides it.
std::string tree_text(const modeller::FacadeState& state);

/// The rules of one node, or, for ".", of all that are divided or open: + those that can be applied
/// with their free numbers, * the one that divides it, - others with why not. Lines that can be
/// moved. For one node also the actions of the paper's modeller.
std::string list_text(const modeller::FacadeState& state, const std::string& path);

}  // namespace vug::cli
