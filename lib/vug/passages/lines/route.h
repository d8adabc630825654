// SPDX-License-Identifier: Apache-2.0
// The way from one station of a cave to another along the axes of its passages, e.g. of a camera.
#pragma once

#include <vug/network/network.h>

#include <vector>

namespace vug::passages {

/// A way through the passages, in scene space.
class Route {
 public:
  /// The shortest way from one station to another, given by their indices, along the legs of a
  /// network that `on_axes` returned. Stations without legs start at the nearest station with one.
  /// Throws Error(bad_input) if no passage joins them, or the network is invalid.
  Route(const network::Network& course, int from, int to);

  /// Metres along the axes; above 0 unless both stations are at one place.
  double length() const { return along_.back(); }
  /// The point after `s` metres: the mean of the axes within half of the passage's smaller size
  /// on both sides, so that corners are rounded and the point stays in the passage. The first and
  /// the last point are those of the axes; beyond them, the way continues straight.
  Vec3d point(double s) const;

 private:
  Vec3d on_legs(double s) const;
  double half_size(double s) const;
  size_t piece(double s) const;

  std::vector<Vec3d> points_;
  std::vector<double> along_;  // Metres up to each point, ascending.
  std::vector<double> sizes_;  // Half of the smaller size of the passage.
};

}  // namespace vug::passages
