// SPDX-License-Identifier: Apache-2.0
// Coordinate systems of surveys and the transformation between them, computed by PROJ [@proj2022].
#pragma once

#include <vug/base/vec.h>

#include <memory>
#include <string>

namespace vug::survey {

/// A place on WGS 84.
struct Geographic {
  double longitude = 0;  ///< Degrees, positive to the east.
  double latitude = 0;   ///< Degrees, positive to the north.
  double height = 0;     ///< Metres above the ellipsoid.
};

/// Coordinate systems are named as in Survex: "EPSG:27700", "ESRI:102009", "UTM30N", "OSGB:SD",
/// "S-MERC", "long-lat", "EUR79Z30", "JTSK", "iJTSK", "JTSK03", "iJTSK03", "local", or a definition
/// of PROJ that begins with "+", or a well-known text (WKT). Coordinates are easting, northing and
/// altitude in metres, or longitude and latitude in degrees. Keeps the transformations that it has
/// made; PROJ starts with the first of them.
class Geodesy {
 public:
  Geodesy();
  ~Geodesy();
  Geodesy(const Geodesy&) = delete;
  Geodesy& operator=(const Geodesy&) = delete;

  /// The reason why a coordinate system is unknown; empty for a valid one.
  std::string fault_of(const std::string& name);
  /// Error(bad_input) if a system is unknown or the place is outside of its area.
  Vec3d transform(const std::string& from, const std::string& to, const Vec3d& place);
  Geographic geographic(const std::string& from, const Vec3d& place);
  /// The direction of true north on the grid: the angle in radians from grid north, clockwise.
  double true_north(const std::string& grid, const Geographic& place);

 private:
  struct Cache;
  Cache& cache();

  std::unique_ptr<Cache> cache_;  ///< Null before its first use.
};

}  // namespace vug::survey
