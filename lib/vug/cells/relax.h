// Harmonising: cells push each other about on the surface until they are evenly spread.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/surface.h>

#include <vector>

namespace vug::cells {

/// The push at distance d, as a share of the greatest; r is the reach, c the spacing.
enum class Force {
  /// (1 - d/r)^2: always away. Leaves a few cells in a hundred without five to seven neighbours.
  squared,
  /// (1 - d/c) (1 - d/r): away up to c, together beyond. Equation 1 of [@gobron2006], whose terms
  /// are those of this product; clumps, and never comes to rest as even as the other.
  paper,
};

struct RelaxOptions {
  Force force = Force::squared;
  int steps = 30;
  double strength = 0.45;  ///< Greatest push of one cell on another in a step, in spacings.
};

/// How even the cells are before a step.
struct RelaxStep {
  double nearest = 0;       ///< Mean distance to the nearest cell, metres.
  double variation = 0;     ///< Standard deviation of that distance as a share of the mean.
  double displacement = 0;  ///< Mean way of a cell in this step, metres.
};

/// Moves the places over the surface and brings them into an order that follows space. A push goes
/// along the tangent plane, by surface_distance2, and the cell comes back to the nearest point of
/// the surface; at an open edge it stays on it. No cell goes further than 0.3 spacings in a step.
std::vector<RelaxStep> relax(std::vector<SurfacePoint>& places, const Surface& surface,
                             double spacing, double reach, const RelaxOptions& options,
                             Progress& progress = Progress::none());

}  // namespace vug::cells
