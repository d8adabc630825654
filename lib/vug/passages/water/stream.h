// SPDX-License-Identifier: Apache-2.0
// The stream of a cave: the heights of its surface from the sources to the outlets.
#pragma once

#include <vug/passages/water/flood.h>

#include <cstdint>
#include <vector>

namespace vug::passages {

/// Sediment on the floor of passages that are not too steep for it.
struct SedimentOptions {
  double depth = 0;                ///< Metres above the lowest point of the section.
  double fill = 0;                 ///< In addition, as a part of the passage's height; 0 to 1.
  double repose = 32 * kPi / 180;  ///< Steeper passages have none; radians, 0 to pi / 2.
};

struct StreamOptions {
  std::vector<int> from{};     ///< Stations with a source; empty: default_sources.
  std::vector<int> to{};       ///< Stations with an outlet; empty: default_outlets.
  double discharge = 0.05;     ///< Water from each source, m^3/s.
  double roughness = 0.05;     ///< Manning's n, s / m^(1/3).
  double fall = kPi / 4;       ///< Steeper water falls freely; radians.
  double spacing = 0.5;        ///< Metres between points of the surface, at most.
  uint64_t seed = 0;           ///< Seed of the distances between riffles.
  SedimentOptions sediment{};  ///< The bed of the stream.
};

/// The surface of the water at each node of the plan.
struct Stream {
  FloorPlan plan;
  std::vector<int> towards;       ///< The next node downstream, -1 at outlets.
  std::vector<double> bed;        ///< Height of the bed at each node.
  std::vector<double> level;      ///< Height of the water; -infinity where it is dry.
  std::vector<double> discharge;  ///< m^3/s; 0 in backwaters.
  std::vector<double> width;      ///< Width of the channel, metres; 0 outside of it.
  std::vector<int> pool;          ///< Nodes with one number have one level; -1 where dry.

  bool wet(int node) const { return level[static_cast<size_t>(node)] > -kInfinity; }
};

/// Heights never rise downstream, and are equal within a pool. Water from each source takes the way
/// of `flood` to an outlet. With the discharge Q in m^3/s, its channel is 4.83 sqrt(Q) wide
/// (lacey1930), but not wider than the passage, and its depth is (n Q / (w sqrt(S)))^(3/5), the
/// uniform flow of Manning (chow1959, eq. 5-6) in a wide channel of slope S. Riffles are 6 widths
/// apart (leopold1964fluvial) up to slopes of 2 %, and 2.5 widths (montgomery1997) from 5 % on,
/// with variations of 30 %. Backwaters fill side passages up to the level where they meet the
/// stream. See docs/explanation/passages.md. Throws Error(bad_input) for options out of range.
Stream stream(const network::Network& network, const PassageOptions& passages,
              const StreamOptions& options);

/// The height of the sediment at each node; the floor where there is none.
std::vector<double> sediment_heights(const FloorPlan& plan, const SedimentOptions& options);

}  // namespace vug::passages
