// SPDX-License-Identifier: Apache-2.0
// Bodies along the lines of a floor plan, given the height of the surface at each node.
#pragma once

#include <vug/passages/water/surface.h>

#include <vector>

namespace vug::passages {

/// Collects the polytopes of a body. Refers to its arguments, which must outlive it.
class BodyBuilder {
 public:
  /// `top`: for each node, the height of the surface, or -infinity where there is none. `overlap`:
  /// metres into walls and floor.
  BodyBuilder(const FloorPlan& plan, const std::vector<double>& top, double overlap);

  /// Appends the body along a line. `separate`: for each edge of the line, nonzero if the body has
  /// a gap there, because water falls. A body ends in a level piece up to the next point without a
  /// surface, beyond dead ends, and under a pitch.
  void append(const FloorLine& line, const std::vector<char>& separate);

  std::vector<Polytope> parts;

 private:
  double top(const FloorPoint& p) const { return top_[static_cast<size_t>(p.node)]; }
  bool covered(const FloorPoint& p) const { return top(p) > -kInfinity; }
  SurfacePoint point(const FloorPoint& place, double height) const;
  void append_run(const FloorLine& line, const std::vector<char>& separate, size_t first,
                  size_t last);

  const FloorPlan& plan_;
  const std::vector<double>& top_;
  double overlap_;
  std::vector<std::vector<int>> adjacent_;
};

}  // namespace vug::passages
