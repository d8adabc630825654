// SPDX-License-Identifier: Apache-2.0
// The generator of karst networks: from the rock and the water to the plan of a cave.
#pragma once

#include <vug/karst/geology.h>
#include <vug/karst/options.h>
#include <vug/network/network.h>

namespace vug::karst {

/// Grows a network. Legs have a stage, a tier, a discharge (0 for passages without a known flow)
/// and the name of their passage ("passage.N"); stations have names and flags, but not
/// cross-sections (see network::draw_sections). The result depends on the arguments only, not on
/// the number of threads. Throws Error(bad_input) for invalid arguments and key points that cannot
/// be placed.
network::Network generate(const Geology& geology, const KarstOptions& options);

}  // namespace vug::karst
