// SPDX-License-Identifier: Apache-2.0
// Stems of a grove: a point process in a plot, projected onto the ground and filtered by growing
// conditions.
#pragma once

#include <vug/base/progress.h>
#include <vug/flora/distribution.h>
#include <vug/flora/ground.h>

#include <functional>
#include <vector>

namespace vug::flora {

struct Stem {
  GroundPoint base;
  double diameter = 0;  ///< Metres; 0 if the grove has no diameters.
  RandomKey key{0};     ///< The stem's own key, independent of other stems.
};

struct GroveOptions {
  DistributionPtr distribution;  ///< Null: uniform.
  double density = 0;            ///< Stems per square metre of the plan; see Distribution.
  /// Minimum distance in the plan, metres: of two closer points the later one is removed. The
  /// density refers to the points before removal.
  double spacing = 0;
  Ground ground = level_ground();
  double steepest = kPi / 2;  ///< Maximum slope of the ground, radians.
  /// Metres above the ground point that must be free of ground and of `avoid`.
  double headroom = 0;
  /// Solids that stems must not stand in or grow into, and the minimum distance to them, metres.
  std::vector<field::Field> avoid;
  double margin = 0;
  /// Probability that a stem is kept at a point, 0 to 1; empty: always. Called by several threads.
  std::function<double(const GroundPoint&)> retention = nullptr;
  /// Diameters are normally distributed; values more than two and a half deviations from the mean,
  /// or not above 0, are redrawn. Metres; 0: no diameters.
  double diameter = 0, diameter_spread = 0;
  RandomKey key{0};
};

/// Numbers of points by outcome. A rejected point is counted once, under the first reason in this
/// order.
struct PlacementStats {
  size_t too_near = 0;   ///< Closer to an earlier point than GroveOptions::spacing.
  size_t no_ground = 0;  ///< No ground below.
  size_t too_steep = 0;
  size_t no_room = 0;  ///< Ground within GroveOptions::headroom.
  size_t avoided = 0;
  size_t thinned = 0;  ///< Removed by GroveOptions::retention.
  size_t placed = 0;
};
PlacementStats placement_stats(const Plot& plot, const GroveOptions& options,
                               Progress& progress = Progress::none());

/// The result does not depend on the number of threads. A stem keeps its key, diameter and position
/// when others are removed. Errors as Distribution::points.
std::vector<Stem> grove(const Plot& plot, const GroveOptions& options,
                        Progress& progress = Progress::none());

/// Index of the diameter with the ratio nearest to `wanted`; ties are broken at random.
size_t nearest_diameter(const std::vector<double>& diameters, double wanted, RandomKey key);

}  // namespace vug::flora
