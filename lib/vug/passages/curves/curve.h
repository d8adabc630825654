// SPDX-License-Identifier: Apache-2.0
// The axis of a passage as a chain of points, each with the size of the section there.
#pragma once

#include <vug/network/network.h>
#include <vug/passages/section.h>

#include <algorithm>
#include <vector>

namespace vug::passages {

struct CurvePoint {
  Vec3d position{0.0};  ///< On the axis, in scene space.
  double width = 1;     ///< Metres.
  double height = 1;
  network::Stage stage = network::Stage::unknown;  ///< The stage of the leg that follows.
  /// The index of the station at this point, or -1.
  int station = -1;
  bool fixed = false;   ///< Other passages meet here: the point must stay.
  SectionPtr measured;  ///< The section from splays, if there are enough of them.

  double smaller() const { return std::min(width, height); }
};
using Curve = std::vector<CurvePoint>;

/// The arc length from the first point to each point, in metres.
std::vector<double> arc_lengths(const Curve& curve);

/// The point between a and b, t in 0..1, with sizes that change smoothly. It is not a station.
CurvePoint between(const CurvePoint& a, const CurvePoint& b, double t);

/// Unit tangents: directions of the legs on both sides, of which the shorter counts more.
std::vector<Vec3d> tangents(const Curve& curve);

}  // namespace vug::passages
