// SPDX-License-Identifier: Apache-2.0
// The flowstone that the water of a graph leaves on floors and walls.
#pragma once

#include <vug/drips/forms.h>
#include <vug/field/speleothems/deposits.h>

namespace vug::drips {

/// Skirts around the feet of standing forms: the water that has passed a trunk spreads and leaves
/// half of what it can still deposit. Radius and thickness grow with discharge and age.
std::vector<field::Deposit> skirts_of(const Graph& graph, const std::vector<Form>& forms);

struct FlowstoneOptions {
  double share = 0.6;  ///< The share of the films on walls and floors that leave flowstone, 0..1.
  uint64_t seed = 1;
};

/// Flowstone along the films on walls and floors, below skirts with the water that these leave. A
/// film wanders: the layer is wider than the film and has the volume of the calcite that it lost,
/// as far as the limits of width and thickness allow. It ends at the water of pools.
std::vector<field::Deposit> flowstone_of(const Graph& graph, const std::vector<Form>& forms,
                                         const FlowstoneOptions& options);

/// The volume in m3 of calcite that water has deposited while its calcium fell from one
/// concentration to another, over its age.
double deposited_volume(const Water& water, double calcium_from, double calcium_to);

}  // namespace vug::drips
