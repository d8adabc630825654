// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: cubes of the voxel lattice and their bounding balls.
#pragma once

#include <vug/field/field.h>

#include <cmath>
#include <cstdint>

namespace vug::volume {

/// size^3 lattice points starting at `origin`; size is a power of two, at least 8.
struct Cell {
  int64_t origin[3] = {0, 0, 0};
  int64_t size = 8;

  Cell child(int n) const {
    const int64_t half = size / 2;
    return {{origin[0] + (n & 4 ? half : 0), origin[1] + (n & 2 ? half : 0),
             origin[2] + (n & 1 ? half : 0)},
            half};
  }
};

/// The ball around the cell's lattice points in world space.
inline field::Ball ball_around(const Cell& cell, double voxel) {
  const double half = 0.5 * static_cast<double>(cell.size - 1);
  auto centre = [&](int axis) { return (static_cast<double>(cell.origin[axis]) + half) * voxel; };
  return {{centre(0), centre(1), centre(2)}, half * voxel * std::sqrt(3.0)};
}

/// Parameters of the narrow band, in metres.
struct NarrowBand {
  double voxel = 0;
  float background = 0;  ///< Half-width of the band.
  bool repair = true;
  float contact = 0;  ///< Values up to it count as inside; see contact.h.
};

/// The largest |value| of the field that can belong to the band or be adjacent to a change of sign.
inline double reach(const NarrowBand& band, const field::Field& field) {
  const double background = static_cast<double>(band.background);
  if (field.exactness() <= field::Exactness::eikonal) return background;
  const double slope = field.lipschitz();
  return band.repair ? background * slope : std::max(background, band.voxel * slope);
}

}  // namespace vug::volume
