// SPDX-License-Identifier: Apache-2.0
// Limits of readings: numbers that no survey contains are refused before they overflow.
#pragma once

#include <vug/survey/measurement.h>
#include <vug/survey_files/byte_reader.h>

#include <cmath>

namespace vug::survey {

constexpr double kLongestLeg = 1e7;         ///< Metres.
constexpr double kLargestCoordinate = 1e9;  ///< Metres.
constexpr double kFarthestWall = 1e4;       ///< Metres; the largest halls measure hundreds.

inline bool is_plausible_coordinate(double value) { return std::fabs(value) <= kLargestCoordinate; }
inline bool is_plausible_wall(double distance) { return std::fabs(distance) <= kFarthestWall; }

constexpr const char* kImplausibleCoordinate = "a coordinate exceeds 1000000 km";
constexpr const char* kImplausibleWall = "a distance to a wall exceeds 10 km";

/// The next number of a binary file as a coordinate, or as a distance to a wall, in units of
/// `metres`. Throws Error(bad_input) with its byte if it is not plausible.
template <class T>
double read_coordinate(ByteReader& in, double metres = 1) {
  const size_t offset = in.offset();
  const double value = metres * static_cast<double>(in.number<T>());
  if (!is_plausible_coordinate(value)) in.fail_at(offset, kImplausibleCoordinate);
  return value;
}
inline double read_wall(ByteReader& in) {
  const size_t offset = in.offset();
  const double value = in.number<double>();
  if (!is_plausible_wall(value)) in.fail_at(offset, kImplausibleWall);
  return value;
}

/// Throws Error(bad_input) with the byte `offset` if a leg of a binary file is longer than 10000
/// km.
inline void require_plausible_leg(const Vec3d& from, const Vec3d& to, const ByteReader& in,
                                  size_t offset) {
  if (!((to - from).length() <= kLongestLeg)) in.fail_at(offset, "a leg is longer than 10000 km");
}

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
    if (!is_plausible_coordinate(position[axis]))
      throw Error(ErrorCode::bad_input, kImplausibleCoordinate, where,
                  "check the coordinates and their unit");
}

/// Throws Error(bad_input) for distances to walls above 10 km.
inline void require_plausible_wall(double distance, const SourceLocation& where) {
  if (!is_plausible_wall(distance))
    throw Error(ErrorCode::bad_input, kImplausibleWall, where, "check the distance and its unit");
}

}  // namespace vug::survey
