// SPDX-License-Identifier: Apache-2.0
// Internal to karst: dead ends and loops, by which a network of main ways becomes a cave.
#pragma once

#include <vug/karst/flow.h>

namespace vug::karst {

/// Adds dead ends, and adds or cuts loops until there are `loops` independent cycles for each
/// junction or end. Cut passages become two dead ends; ways of water are not cut. Stops early if no
/// free samples remain.
void grow(const FlowCost& cost, const KarstOptions& options, Plan& plan);

/// Cuts a passage that is part of a loop and not the way of water to a spring; returns false if
/// none exists.
bool cut_loop(RandomStream& random, Plan& plan);

}  // namespace vug::karst
