// SPDX-License-Identifier: Apache-2.0
// The floors of the passages of a network: points along their axes with the heights of floor and
// roof and the places of the walls, as a graph in which water can run.
#pragma once

#include <vug/network/network.h>
#include <vug/passages/passages.h>

#include <vector>

namespace vug::passages {

/// The vector without its vertical part.
inline Vec3d in_plan(const Vec3d& v) { return {v.x, 0, v.z}; }

/// A cross-section as water sees it. Heights are coordinates y in metres.
struct FloorNode {
  /// Between the walls, and along the passage in plan where the floor is lowest: steep passages
  /// have their floor next to the axis, not below it. The height is that of the axis.
  Vec3d position{0.0};
  double floor = 0;  ///< The lowest point of the section.
  double roof = 0;   ///< The highest point.
  double width = 0;  ///< Metres across the passage in plan.
  int station = -1;  ///< The station at this point, or -1.
};

/// A node as a point of a passage. Vectors in plan are horizontal.
struct FloorPoint {
  int node = 0;
  Vec3d right{1, 0, 0};  ///< The horizontal direction across the passage, a unit vector.
  double left_wall = 0;  ///< Metres along `right` to the walls; negative on the left.
  double right_wall = 0;
  double reach = 0;  ///< Metres along the passage in plan that a steep section covers.
};
using FloorLine = std::vector<FloorPoint>;

struct FloorPlan {
  std::vector<FloorNode> nodes;
  std::vector<FloorLine> lines;  ///< One for each passage; they share nodes at junctions.
};

/// Points at most `spacing` metres apart along the axes that `passages` has with the same options.
/// At a junction, the section is that of the passage that continues. Throws as `passages` does, and
/// Error(too_large) for more than 500,000 points.
FloorPlan floor_plan(const network::Network& network, const PassageOptions& options,
                     double spacing);

/// The neighbours of each node, in the order of the lines.
std::vector<std::vector<int>> neighbours(const FloorPlan& plan);

/// Metres between two nodes in plan.
double plan_distance(const FloorPlan& plan, int a, int b);

}  // namespace vug::passages
