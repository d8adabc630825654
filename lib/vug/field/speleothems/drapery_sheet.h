// SPDX-License-Identifier: Apache-2.0
// The sheet of a drapery, which grows downwards from the path of a film under a sloping roof.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/speleothems/sheet.h>

namespace vug::field {

struct Drapery {
  std::vector<Vec3d> path{};      ///< Along the roof, from the first drop down; metres, y up.
  double width = 0.4;             ///< Greatest height of the sheet below its path.
  double edge = 0.005;            ///< Thickness of its lower edge: the width of a drop.
  double root_thickness = 0.015;  ///< Thickness at the path.
  double fold = 0.12;             ///< Mean distance of folds along the path; 0: none.
  double root = 0;                ///< Height by which it continues into the roof.
  double finest = 0;              ///< Least distance of corners: what a voxel carries.
};

/// The height of the sheet relative to its width, at a fraction of the length of the path: it grows
/// with the water that has passed, and ends in a point.
double drapery_profile(double along);

/// Points of the path at equal steps of its length, at most the given distance apart.
std::vector<Vec3d> resampled(const std::vector<Vec3d>& path, double step);

/// Corners from the root to the edge for each point of the path. Folds swing to both sides by a
/// quarter of their distance at the edge and vanish at the root; the layers of growth are parallel
/// to the edge and vary in thickness.
Sheet drapery_sheet(const Drapery& drapery, RandomKey key);

}  // namespace vug::field
