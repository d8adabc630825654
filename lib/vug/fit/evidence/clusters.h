// SPDX-License-Identifier: Apache-2.0
// Clusters of pixels with similar colour and depth.
#pragma once

#include <vug/base/rng.h>
#include <vug/fit/evidence/evidence.h>
#include <vug/fit/evidence/features.h>

namespace vug::fit {

struct ClusterOptions {
  int clusters = 6;  ///< At most kMaxLanes.
  int rounds = 20;
  int attempts = 4;  ///< Runs with different start centres; the run with the smallest error wins.
  /// L*a*b* units per metre of depth.
  double depth_scale = 60;
};

/// The cluster of each pixel by k-means (cite lloyd1982) with k-means++ initialisation (cite
/// arthur2007). The planes are L*, a*, b* and optionally depth in metres, NaN without a return.
/// Yields fewer clusters if the picture has fewer colours; the darkest cluster comes first.
/// Error(bad_input) for counts out of range.
std::vector<uint8_t> cluster(const Planes& planes, const ClusterOptions& options, RandomKey key);

}  // namespace vug::fit
