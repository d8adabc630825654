// SPDX-License-Identifier: Apache-2.0
// Passages meet at stations or keep apart, as those of real caves do.
#pragma once

#include <vug/karst/sample_graph.h>

namespace vug::karst {

/// Sine of the least angle between two legs at a station; about 35 degrees. Nearly parallel legs
/// would be one passage.
inline constexpr double kLeastSine = 0.574;
/// Distance from a station, in separations, at which legs with the least angle are separate.
inline constexpr double kMeeting = 1.8;

/// The graph without edges that come closer than `separation` metres to a cheaper one, or leave a
/// station in nearly the same direction, so that any set of edges is a set of passages without
/// crossings. An edge that is the only way between two of the first `key_points` points remains
/// even so. These points may lie close to each other, and count as one station where they do.
SampleGraph separated(SampleGraph graph, int key_points, double separation);

/// For each point the first of the key points within the distance, or the point itself.
std::vector<int> stations_of_points(const std::vector<Vec3d>& points, int key_points,
                                    double distance);

}  // namespace vug::karst
