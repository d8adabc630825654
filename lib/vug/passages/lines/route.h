// SPDX-License-Identifier: Apache-2.0
// The way from one station of a cave to another along the axes of its passages, e.g. of a camera.
#pragma once

#include <vug/network/network.h>
#include <vug/passages/passages.h>

#include <vector>

namespace vug::passages {

/// A way through the passages, in scene space.
class Route {
 public:
  /// The shortest way along the axes from one station to another, given by their indices. Stations
  /// that are not on an axis start at its nearest point. Throws Error(bad_input) if no passage
  /// joins them, and as `passages` does for the network.
  Route(const network::Network& network, const PassageOptions& options, int from, int to);

  /// Metres along the axes; above 0 unless both stations are at one place.
  double length() const { return along_.back(); }
  /// The point after `s` metres: the mean of the axes within half of the passage's smaller size
  /// on both sides, so that corners are rounded and the point stays in the passage. The first and
  /// the last point are those of the axes; beyond them, the way continues straight.
  Vec3d point(double s) const;

 private:
  Vec3d on_axes(double s) const;
  double half_size(double s) const;
  size_t piece(double s) const;

  std::vector<Vec3d> points_;
  std::vector<double> along_;  // Metres up to each point, ascending.
  std::vector<double> sizes_;  // Half of the smaller size of the passage.
};

}  // namespace vug::passages
