// Cluster images: a picture's pixels in few groups of like colour, and depth.
#pragma once

#include <vug/base/rng.h>
#include <vug/fit/evidence/evidence.h>
#include <vug/fit/evidence/features.h>

namespace vug::fit {

struct ClusterOptions {
  int clusters = 6;  ///< At most kMostLanes.
  int rounds = 20;
  int attempts = 4;  ///< From other starts; the one of least error is taken.
  /// How many units of L*a*b* one metre of depth is worth.
  double depth_scale = 60;
};

/// The cluster of each pixel, by k-means (cite lloyd1982) from starts far apart (cite arthur2007):
/// of planes L*, a*, b* and perhaps, as a fourth, depth in metres, NaN where there is none. Fewer
/// clusters where the picture has fewer colours; the darkest is the first. Error(bad_input) for
/// counts out of range.
std::vector<uint8_t> cluster(const Planes& planes, const ClusterOptions& options, RandomKey key);

}  // namespace vug::fit
