// SPDX-License-Identifier: Apache-2.0
// Walls of a facade in front of and behind its plane: gables, bays, recessed parts.
#pragma once

#include <vug/scan/plane.h>

namespace vug::scan {

/// Distances of the facade's walls in front of the plane, metres, from back to front, 0 among them.
/// A further wall is a slab as thick as the plane's, at most 2 m from it, that holds at least a
/// tenth as many points as the plane and twice as many as the slab in front of it or behind it, and
/// whose largest connected group is at least half as high: panes, signs and parked cars are lower.
std::vector<double> parallel_walls(const PointCloud& cloud, const PlaneFit& plane);

}  // namespace vug::scan
