// SPDX-License-Identifier: Apache-2.0
// The solids of water and of sediment in the passages of a network.
#pragma once

#include <vug/field/field.h>
#include <vug/passages/water/stream.h>

namespace vug::passages {

/// Metres by which the bodies extend into the rock around the passages.
inline constexpr double kOverlap = 0.5;

enum class StreamPart { all, surface, falls };

struct StreamBodyOptions {
  double overlap = kOverlap;  ///< Metres by which the water extends into the walls.
  double thickness = 0.1;     ///< Thickness of falling water in metres, at least.
  StreamPart part = StreamPart::all;
};

/// The water of a stream, its pools, riffles and backwaters (`surface`) and its falls: negative
/// below the surface, in the passages and in the rock around them.
field::Field stream_body(const network::Network& network, const PassageOptions& passages,
                         const StreamOptions& options, const StreamBodyOptions& body = {});

/// The sediment on the floors, with a surface that is level across the passage.
field::Field sediment_body(const network::Network& network, const PassageOptions& passages,
                           const SedimentOptions& options, double overlap);

/// Standing water in the basins of the floors, each with one level: the height at which it would
/// spill, but at most `depth` metres above the lowest point of its bed. `outlets`: stations from
/// which water leaves; empty: default_outlets.
field::Field pond_body(const network::Network& network, const PassageOptions& passages,
                       const SedimentOptions& bed, const std::vector<int>& outlets, double depth,
                       double overlap);

/// The level of the pond at each node, -infinity where it is dry; see pond_body.
std::vector<double> pond_levels(const FloorPlan& plan, const std::vector<double>& bed,
                                const std::vector<int>& outlets, double depth);

}  // namespace vug::passages
