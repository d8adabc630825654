// SPDX-License-Identifier: Apache-2.0
// The axes of the passages of a network as straight lines downstream, with the height of the floor.
#pragma once

#include <vug/network/network.h>
#include <vug/passages/passages.h>

#include <vector>

namespace vug::passages {

/// A straight piece of the axis of a passage, in scene space.
struct AxisLine {
  Vec3d from{0.0};
  Vec3d to{0.0};                        ///< Downstream; differs from `from`.
  double along = 0;                     ///< Metres from the upper end of the passage to `from`.
  double floor_from = 0, floor_to = 0;  ///< Heights of the lowest points of the sections, y.
  Vec3d up{0, 1, 0};  ///< The upward direction of the sections, perpendicular to the line.

  Vec3d vector() const { return to - from; }
};

/// The axes along which `passages` sweeps its sections with the same options, which ends at the
/// axis of another passage where they meet. The water runs as in most of the length of the legs of
/// a passage. Throws as `passages` does for the network.
std::vector<AxisLine> axis_lines(const network::Network& network, const PassageOptions& options);

}  // namespace vug::passages
