// SPDX-License-Identifier: Apache-2.0
// The graph of drips as points for other programs.
#pragma once

#include <vug/drips/graph.h>
#include <vug/volume/points.h>

namespace vug::delivery {

/// One point for each node, with the attributes N, id (of the drip), kind (index of NodeKind),
/// discharge (mm3/s), calcium (mol/m3), temperature (degrees Celsius) and age (years), and one
/// group for each kind of node.
volume::Points drip_points(const drips::Graph& graph);

}  // namespace vug::delivery
