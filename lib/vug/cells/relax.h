// SPDX-License-Identifier: Apache-2.0
// Relaxation: cells repel each other on the surface until they are evenly distributed.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/surface.h>

#include <vector>

namespace vug::cells {

/// The force at distance d, relative to its maximum; r is the reach, c the spacing.
enum class Force {
  /// (1 - d/r)^2: always repulsive. A few percent of the cells end up without five to seven
  /// neighbours.
  squared,
  /// (1 - d/c) (1 - d/r): repulsive up to c, attractive beyond. Equation 1 of [@gobron2006], whose
  /// terms are those of this product. It forms clumps and never becomes as uniform as the other.
  paper,
};

struct RelaxOptions {
  Force force = Force::squared;
  int steps = 30;
  double strength = 0.45;  ///< Maximum displacement caused by one cell in a step, in spacings.
};

/// Statistics before a step.
struct RelaxStep {
  double nearest = 0;       ///< Mean distance to the nearest cell, metres.
  double variation = 0;     ///< Standard deviation of that distance relative to the mean.
  double displacement = 0;  ///< Mean displacement of a cell in this step, metres.
};

/// Moves the points over the surface and sorts them into an order that follows space. Forces act
/// along the tangent plane, by surface_distance2, and each cell is projected back to the nearest
/// point of the surface; at an open edge it stays on the edge. A cell moves at most 0.3 spacings
/// per step.
std::vector<RelaxStep> relax(std::vector<SurfacePoint>& places, const Surface& surface,
                             double spacing, double reach, const RelaxOptions& options,
                             Progress& progress = Progress::none());

}  // namespace vug::cells
