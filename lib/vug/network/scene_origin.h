// SPDX-License-Identifier: Apache-2.0
// The point of survey space that becomes the origin of a scene. Meshes have single precision, which
// is 0.5 m at the coordinates of a national grid, so that networks stay near the origin.
#pragma once

#include <vug/base/vec.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::network {

/// The largest distance in metres of a station from an origin that the user chose: single precision
/// is 2 mm there.
inline constexpr double kFarthestStation = 2e4;

struct OriginOptions {
  /// Moves the network so that the middle of its bounding box, rounded to metres, is the origin of
  /// the scene; otherwise (0, 0, 0) of survey space is the origin.
  bool recenter = true;
  /// The point of survey space (east, north, height in metres) that is the origin of the scene,
  /// instead of the middle. Several networks with the same point share an origin.
  std::optional<Vec3d> origin{};
};

struct NamedPoint {
  std::string name;  ///< May be empty.
  Vec3d position{0.0};
};

/// The origin for the points of a network in survey space (metres). Throws Error(bad_input) if the
/// options contradict each other or if a point is farther than kFarthestStation from an origin that
/// they choose.
Vec3d scene_origin(const std::vector<NamedPoint>& points, const OriginOptions& options);

}  // namespace vug::network
