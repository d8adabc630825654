// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/kind.h>

#include <cmath>

namespace vug::cells {
namespace {

/// Only x and y of the vectors are used: a pattern is planar.
struct Pattern {
  std::vector<Vec3d> points = {Vec3d(0)};
  Vec3d across{1, 0, 0};
  Vec3d along{0, 1, 0};
  int neighbors = 6;
  double reach = 1.5;

  static void describe(Schema<Pattern>& s) {
    s.doc("A custom pattern that repeats in two directions; all lengths in spacings.")
        .param("points", &Pattern::points, {.doc = "cells of one period: x and y of each"})
        .param("across", &Pattern::across, {.doc = "vector from a period to the next: x and y"})
        .param("along", &Pattern::along,
               {.doc = "vector from a row of periods to the next: x and y"})
        .param("neighbors", &Pattern::neighbors,
               {.doc = "maximum number of links per cell, to the nearest neighbours",
                .min = 1,
                .max = 8})
        .param(
            "reach", &Pattern::reach,
            {.doc = "cells further apart are not linked", .min = 0, .max = 4, .above_min = true});
  }
  std::string fault() const {
    if (points.empty()) return "a pattern needs at least one point";
    if (points.size() > 4096) return "a pattern has at most 4096 points";
    if (!(std::fabs(across.x * along.y - across.y * along.x) > 1e-3))
      return "the directions of a pattern must not be parallel";
    return "";
  }
  Grid grid() const {
    Grid grid;
    for (const Vec3d& p : points) grid.motif.emplace_back(p.x, p.y);
    grid.across = Vec2d(across.x, across.y);
    grid.along = Vec2d(along.x, along.y);
    grid.reach = reach;
    grid.full = static_cast<uint32_t>(neighbors);
    grid.thin = 0.3;
    grid.gap = std::max(1.0, reach);
    return grid;
  }
};

}  // namespace
}  // namespace vug::cells

VUG_GRID_KIND(pattern) { return grid_kind<Pattern>("pattern"); }
