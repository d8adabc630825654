// SPDX-License-Identifier: Apache-2.0
// The points between which water can flow.
#pragma once

#include <vug/karst/key_points.h>

#include <array>
#include <vector>

namespace vug::karst {

/// The key points, in the order sinks, springs, entrances, waypoints, and after them the samples.
struct Samples {
  std::vector<Vec3d> points;
  int sinks = 0;  ///< Index of the first sink, and so on.
  int springs = 0;
  int entrances = 0;
  int waypoints = 0;
  int random = 0;  ///< Index of the first point that is not a key point.
  /// Pairs of samples that follow each other on a joint, sorted; empty without a joint network.
  std::vector<std::array<int, 2>> joint_edges;
};

/// Random samples on beds, on joints, in permeable rock and in the rest of the rock, each at least
/// a distance from the others of its kind that depends on their number (dart throwing). If no more
/// fit, there are fewer samples than the options request.
Samples draw_samples(const Rock& rock, const KeyPoints& keys, const KarstOptions& options);

}  // namespace vug::karst
