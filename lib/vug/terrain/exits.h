// SPDX-License-Identifier: Apache-2.0
// Places where the passages of a network leave the ground.
#pragma once

#include <vug/field/ground.h>
#include <vug/network/network.h>

#include <string>
#include <vector>

namespace vug::terrain {

struct Exit {
  Vec3d position;  ///< A point of the passage's axis, where its roof is highest above the ground.
  std::string station;  ///< The nearest station on its leg; may be empty.
  double height = 0;    ///< Metres of the roof above the ground there.
};

/// One exit for each connected part of the network's legs whose roof is more than `tolerance`
/// metres above the ground, the highest first. The roof is the axis and the measured distance up.
/// Legs over the surface do not count, nor do places within 10 m, or the width and height of the
/// passage, of an opening: a station flagged as an entrance, a sink or a spring, or on the surface.
/// In a network without such flags, the ends of passages are openings.
std::vector<Exit> exits(const network::Network& network, const field::Ground& ground,
                        double tolerance);

}  // namespace vug::terrain
