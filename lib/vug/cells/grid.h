// A grid: the pattern in which cells are first laid, and how many neighbours they keep (gobron2006,
// sections 3 and 4.3). Lengths are in spacings.
#pragma once

#include <vug/base/vec.h>

#include <string>
#include <vector>

namespace vug::cells {

struct Grid {
  std::string name;
  /// Points of one period of the pattern; empty: cells are strewn at random.
  std::vector<Vec2d> motif;
  Vec2d across{1, 0};  ///< From a period to the next.
  Vec2d along{0, 1};   ///< The same for rows of periods.
  double reach = 1.5;  ///< Cells further apart over the surface are never linked, r_i.
  uint32_t full = 4;   ///< Links of a cell at most, l_g.
  double thin = 0.6;   ///< Of cells nearer than this, as where facets meet, one stays.
  double gap = 0.85;   ///< Where no cell is nearer than this, as there too, one is added.
  int relax = 0;       ///< Steps of harmonising that do the grid good.
};

}  // namespace vug::cells
