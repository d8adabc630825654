// SPDX-License-Identifier: Apache-2.0
// A grid: the initial pattern of cells and their number of neighbours (gobron2006, sections 3 and
// 4.3). Lengths are in spacings.
#pragma once

#include <vug/base/vec.h>

#include <string>
#include <vector>

namespace vug::cells {

struct Grid {
  std::string name;
  /// Points of one period of the pattern; empty: random points.
  std::vector<Vec2d> motif;
  Vec2d across{1, 0};  ///< Vector from one period to the next.
  Vec2d along{0, 1};   ///< Vector from one row of periods to the next.
  double reach = 1.5;  ///< Cells further apart on the surface are never linked, r_i.
  uint32_t full = 4;   ///< Maximum number of links per cell, l_g.
  double thin =
      0.6;  ///< Minimum distance: of two closer cells, for example where facets meet, one remains.
  double gap =
      0.85;       ///< A cell is added wherever no cell is nearer than this, also where facets meet.
  int relax = 0;  ///< Recommended number of relaxation steps.
};

}  // namespace vug::cells
