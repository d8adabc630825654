// SPDX-License-Identifier: Apache-2.0
// The ends of a cave: where it begins, and the station that is farthest from there.
#pragma once

#include <vug/network/network.h>

namespace vug::network {

/// The first entrance, else the first station; -1 without stations.
int first_station(const Network& network);

/// The station with the longest shortest way over legs from `from`, the first of equal ones; `from`
/// itself if it has no legs.
int farthest_station(const Network& network, int from);

}  // namespace vug::network
