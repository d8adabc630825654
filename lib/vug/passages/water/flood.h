// SPDX-License-Identifier: Apache-2.0
// The levels to which basins fill before they spill, and the ways by which water leaves them.
#pragma once

#include <vug/passages/water/floor_plan.h>

#include <vector>

namespace vug::passages {

struct Flood {
  /// For each node, the least height to which water must rise to leave by an outlet, at least that
  /// of the bed.
  std::vector<double> level;
  /// The next node on the way to an outlet; -1 at outlets.
  std::vector<int> towards;
  /// The nodes so that each follows the one towards which its water runs.
  std::vector<int> order;
};

/// The priority flood of barnes2014 on a graph: nodes are visited from the outlets in the order of
/// their levels, and of the distance to an outlet on level ground. `bed`: a height for each node.
/// Nodes from which no outlet can be reached drain to the lowest of them.
Flood flood(const FloorPlan& plan, const std::vector<double>& bed, const std::vector<int>& outlets);

/// The nodes at these stations. Throws Error(bad_input) for a station without a passage.
std::vector<int> nodes_at(const FloorPlan& plan, const network::Network& network,
                          const std::vector<int>& stations);

/// The nodes at springs; without any, the end of a passage with the lowest floor, or the lowest
/// node of all.
std::vector<int> default_outlets(const FloorPlan& plan, const network::Network& network);
/// The nodes at sinks; without any, the end of a passage with the highest floor, or the highest
/// node of all.
std::vector<int> default_sources(const FloorPlan& plan, const network::Network& network);

}  // namespace vug::passages
