// SPDX-License-Identifier: Apache-2.0
// The steady profile of a dome of travertine (goldenfeld2006): r = r0 (sin t / cos^3 t)^(1/2) for
// the slope t of the surface.
#pragma once

#include <vug/base/vec.h>

#include <vector>

namespace vug::field {

/// r / r0 where the tangent of the slope is s: (s (1 + s^2))^(1/2), s >= 0.
double dome_radius(double s);
/// Depth below the top over r0 there: the integral of s dr.
double dome_depth(double s);

/// `count` points from the foot, at height 0 with this radius in metres and slope in radians, to
/// the top on the axis.
std::vector<Vec2d> dome_points(double radius, double slope, int count);

}  // namespace vug::field
