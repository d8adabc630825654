// SPDX-License-Identifier: Apache-2.0
// Cluster point processes: clumps with Poisson-distributed centres and stems around each.
#pragma once

#include <vug/flora/distribution.h>

#include <functional>

namespace vug::flora {

struct ClusterProcessOptions {
  double per_clump = 10;  ///< Mean number of stems per clump (Poisson-distributed), above 0.
  double reach = 1;       ///< Maximum distance of a stem from the centre of its clump, metres.
  /// Offset of a stem from the centre of its clump.
  std::function<Vec2d(RandomStream&)> offset;
};

/// A Neyman-Scott process observed in the plot. Centres also lie outside of the plot, up to the
/// reach of their stems, so that the density does not fall towards the border; they form one
/// Poisson process on the enlarged bounding box. Errors as Distribution::points.
std::vector<Vec2d> cluster_points(const Plot& plot, double density, RandomKey key,
                                  Progress& progress, const ClusterProcessOptions& options);

}  // namespace vug::flora
