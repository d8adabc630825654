// Stems of a grove: a point process in a plot, set on ground, without those that cannot grow.
#pragma once

#include <vug/base/progress.h>
#include <vug/flora/distribution.h>
#include <vug/flora/ground.h>

#include <functional>
#include <vector>

namespace vug::flora {

struct Stem {
  GroundPoint base;
  double diameter = 0;  ///< Metres; 0 where the grove has no diameters.
  RandomKey key{0};     ///< Its own, whatever becomes of others.
};

struct GroveOptions {
  DistributionPtr distribution;  ///< Null: uniform.
  double density = 0;            ///< Stems for each square metre of the plan; see Distribution.
  /// Metres along the plan; of two that are nearer the later one goes. The density is that before.
  double spacing = 0;
  Ground ground = level_ground();
  double steepest = kPi / 2;  ///< Radians that the ground may slope.
  double headroom = 0;        ///< Metres that must be free above a foot, of ground and `avoid`.
  /// Solids that no stem stands in or grows into; and how near to them none stands, metres.
  std::vector<field::Field> avoid;
  double margin = 0;
  /// Share of the stems that stay at a place, 0 to 1; empty: all. Called by several threads.
  std::function<double(const GroundPoint&)> retention = nullptr;
  /// Diameters are normally distributed; those further than two and a half deviations from the mean
  /// or not above 0 are drawn again. Metres; 0: none.
  double diameter = 0, diameter_spread = 0;
  RandomKey key{0};
};

/// What becomes of the points of the process; each that does not stand is counted once, under the
/// first reason in this order.
struct PlacementStats {
  size_t too_near = 0;   ///< To an earlier one: GroveOptions::spacing.
  size_t no_ground = 0;  ///< Below them.
  size_t too_steep = 0;
  size_t no_room = 0;  ///< Ground hangs over them: GroveOptions::headroom.
  size_t avoided = 0;
  size_t thinned = 0;  ///< GroveOptions::share.
  size_t placed = 0;
};
PlacementStats placement_stats(const Plot& plot, const GroveOptions& options,
                               Progress& progress = Progress::none());

/// The same for any number of threads. A stem keeps its key, diameter and place when others go.
/// Errors as Distribution::points.
std::vector<Stem> grove(const Plot& plot, const GroveOptions& options,
                        Progress& progress = Progress::none());

/// Of the diameters the one next to `wanted` by ratio; of several that are the same, one by chance.
size_t nearest_diameter(const std::vector<double>& diameters, double wanted, RandomKey key);

}  // namespace vug::flora
