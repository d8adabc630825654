// SPDX-License-Identifier: Apache-2.0
// Still water in a hollow of any rock, up to a level.
#pragma once

#include <vug/passages/water/polytopes.h>

namespace vug::passages {

struct FillOptions {
  std::vector<Vec3d> at;  ///< Points of the air in or above the water, at least one.
  double level = 0;       ///< Height y of the surface, metres.
  Box3d region;           ///< The water must not leave it.
  double cell = 0.1;      ///< Edge of the cells whose centres are examined, metres.
  bool cut = false;       ///< The faces of the region end the water where it would leave.
};

/// Boxes that contain the air below the level that water from the points can reach, through cells
/// with a common face. They extend into the rock by one and a half cells, so that the surface of
/// the rock is the shore, and end exactly at the level. Gaps narrower than a cell may be missed.
/// Error(bad_input) for a point that is in rock or outside the region, and, with its place, for a
/// leak through which the water leaves the region; Error(too_large) for too many cells.
std::vector<Polytope> filled_hollow(const field::Field& rock, const FillOptions& options);

/// The water as a field, negative inside, which is computed when a value is first needed. The rock
/// is positive in air.
field::Field fill_body(const field::Field& rock, const FillOptions& options);

}  // namespace vug::passages
