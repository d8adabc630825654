// SPDX-License-Identifier: Apache-2.0
// Limits of readings: numbers that no survey contains are refused before they overflow.
#pragma once

#include <vug/survey/measurement.h>

#include <cmath>

namespace vug::survey {

constexpr double kLongestLeg = 1e7;         ///< Metres.
constexpr double kLargestCoordinate = 1e9;  ///< Metres.
constexpr double kFarthestWall = 1e5;       ///< Metres.

/// Throws Error(bad_input) if the vector is longer than 10000 km or the covariance not finite.
inline void require_plausible(const MeasuredVector& leg, const SourceLocation& where) {
  const Covariance& c = leg.covariance;
  if (!(leg.vector.length() <= kLongestLeg) || !std::isfinite(c.xx + c.yy + c.zz) ||
      !std::isfinite(c.xy + c.yz + c.zx))
    throw Error(ErrorCode::bad_input,
                "the leg is longer than 10000 km, or its standard deviations are too large", where,
                "check the readings, their units and calibrations");
}

/// Throws Error(bad_input) for coordinates beyond a million kilometres.
inline void require_plausible(const Vec3d& position, const SourceLocation& where) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::fabs(position[axis]) <= kLargestCoordinate))
      throw Error(ErrorCode::bad_input, "a coordinate exceeds 1000000 km", where,
                  "check the coordinates and their unit");
}

/// Throws Error(bad_input) for distances to walls above 100 km.
inline void require_plausible_wall(double distance, const SourceLocation& where) {
  if (!(std::fabs(distance) <= kFarthestWall))
    throw Error(ErrorCode::bad_input, "a distance to a wall exceeds 100 km", where,
                "check the distance and its unit");
}

}  // namespace vug::survey
