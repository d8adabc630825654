// Cluster processes: clumps whose middles are a Poisson process, each with its stems about it.
#pragma once

#include <vug/flora/distribution.h>

#include <functional>

namespace vug::flora {

struct ClusterProcessOptions {
  double per_clump = 10;  ///< Stems of a clump on average (a Poisson number), above 0.
  double reach = 1;       ///< Metres from its middle that a stem is at most.
  /// A stem's place from the middle of its clump.
  std::function<Vec2d(RandomStream&)> offset;
};

/// A Neyman-Scott process seen in the plot: middles also lie outside, as far as their stems reach,
/// so that the density does not fall towards the border. Middles are one Poisson process on the box
/// around that. Errors as Distribution::points.
std::vector<Vec2d> cluster_points(const Plot& plot, double density, RandomKey key,
                                  Progress& progress, const ClusterProcessOptions& options);

}  // namespace vug::flora
