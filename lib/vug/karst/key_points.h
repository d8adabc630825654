// SPDX-License-Identifier: Apache-2.0
// The points that a network must contain, given or random.
#pragma once

#include <vug/karst/options.h>
#include <vug/karst/rock.h>

namespace vug::karst {

struct KeyPoints {
  std::vector<Sink> sinks;
  std::vector<Spring> springs;  ///< At least one for each tier if there are sinks.
  std::vector<Vec3d> entrances;
  std::vector<Vec3d> waypoints;
};

/// The key points of the geology; missing sinks, springs and waypoints are random: sinks on the
/// surface, springs at the water table on the side towards which the table falls, waypoints on beds
/// (or in permeable balls) at distances from each other. Throws Error(bad_input) if they cannot be
/// placed, or if the network would have fewer than two key points.
KeyPoints key_points(const Rock& rock, const KarstOptions& options);

}  // namespace vug::karst
