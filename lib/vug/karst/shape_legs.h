// SPDX-License-Identifier: Apache-2.0
// Internal to karst: the courses of all passages, which keep apart.
#pragma once

#include <vug/karst/shape.h>

namespace vug::karst {

/// The points of each leg of a network, both ends included. Legs that come closer to each other
/// than the separation of the options, other than near a station that they share, are drawn again
/// with smaller displacements, and at last are straight. Stations with equal `places` are shared.
std::vector<std::vector<Vec3d>> shape_legs(const network::Network& network,
                                           const std::vector<int>& places, const Rock& rock,
                                           const KarstOptions& options);

}  // namespace vug::karst
