// SPDX-License-Identifier: Apache-2.0
// The flowstone that the water of a graph leaves on floors and walls.
#pragma once

#include <vug/drips/forms.h>
#include <vug/field/speleothems/deposits.h>

namespace vug::drips {

/// Skirts around the feet of standing forms: the water that has passed a trunk spreads and leaves
/// half of what it can still deposit. Radius and thickness grow with discharge and age.
std::vector<field::Deposit> skirts_of(const Graph& graph, const std::vector<Form>& forms);

/// The volume in m3 of calcite that water has deposited while its calcium fell from one
/// concentration to another, over its age.
double deposited_volume(const Water& water, double calcium_from, double calcium_to);

}  // namespace vug::drips
