// SPDX-License-Identifier: Apache-2.0
// The surface of a wall as a reference for set-backs: facades bulge and lean, and scans drift.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

struct WallOptions {
  double step = 2;    ///< Distance between the nodes of the surface, metres.
  double cell = 0.1;  ///< Side length of the cells in metres; each contributes its median depth.
  /// Distance from the wall, in metres, within which cells have roughly full weight.
  double noise = 0.03;
  double stiffness = 1;  ///< Weight of bending relative to the cells around a node.
};

/// Depths in front of the plane at the nodes of a grid, interpolated bilinearly.
struct Wall {
  int across = 1, up = 1;  ///< Number of nodes along x and y.
  double step = 1;         ///< Node distance in metres.
  std::vector<double> depths = {0};
  double rms = 0;  ///< Residual of the cells near the wall, metres.

  /// Depth at a point in metres from the range image's lower left corner.
  double at(const Vec2d& place) const;
};

/// The plane itself.
inline Wall flat_wall() { return {}; }

/// Iteratively reweighted least squares. At first all cells count equally; then cells in front of
/// the surface get more weight than cells behind it [@newey1987], since openings are set back, and
/// the weight falls with the distance [@geman1985robust]. A bending penalty between nodes continues
/// the surface under openings and holes. `only`, if it is not empty, has one entry per pixel;
/// pixels with 0 are ignored.
Wall fit_wall(const RangeImage& range, const WallOptions& options = {},
              const std::vector<uint8_t>& only = {});

}  // namespace vug::scan
