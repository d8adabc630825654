// SPDX-License-Identifier: Apache-2.0
// Curves that bend at random: their curvature is an Ornstein-Uhlenbeck process along the arc.
#pragma once

#include <vug/base/frames.h>
#include <vug/base/rng.h>

#include <vector>

namespace vug::field {

struct RandomCurve {
  double length = 0.1;        ///< Metres.
  double step = 0.002;        ///< Between points, metres.
  double curvature = 100;     ///< Standard deviation of each component of the curvature, 1/m.
  double correlation = 0.01;  ///< Arc length over which the curvature changes, metres.
};

/// Frames with their points along the curve, from `at` with the tangent of `first`. The curvature
/// has two components, along the normal and the binormal, and starts with its stationary
/// distribution. Gravity has no influence.
struct CurvePoint {
  Vec3d at;
  Frame frame;
};
std::vector<CurvePoint> random_curve(const RandomCurve& curve, const Vec3d& at, const Frame& first,
                                     RandomStream& random);

}  // namespace vug::field
