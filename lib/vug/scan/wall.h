// The wall behind which windows are set back: facades bulge and lean, and scans drift.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

struct WallOptions {
  double step = 2;       ///< Metres between the nodes of the surface.
  double cell = 0.1;     ///< Metres on a side; each cell has one say, its median depth.
  double noise = 0.03;   ///< Metres from the wall within which cells count in full, about.
  double stiffness = 1;  ///< Weight of a bend against that of the cells around a node.
};

/// Depths before the plane at the nodes of a grid, bilinear between them.
struct Wall {
  int across = 1, up = 1;  ///< Nodes.
  double step = 1;         ///< Metres.
  std::vector<double> depths = {0};
  double rms = 0;  ///< Metres between the wall and the cells that count.

  /// At a place in metres from the range image's lower left corner.
  double at(const Vec2d& place) const;
};

/// The plane itself.
inline Wall flat_wall() { return {}; }

/// By least squares that are weighted anew in turns: first all cells alike, then what lies before
/// the surface pulls harder than what lies behind it [@newey1987], since openings are set back, and
/// cells count the less the farther they are from it [@geman1985robust]. Bends between nodes are
/// held down, so the surface goes on under openings and holes.
Wall fit_wall(const RangeImage& range, const WallOptions& options = {});

}  // namespace vug::scan
