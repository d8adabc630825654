// SPDX-License-Identifier: Apache-2.0
// Smooth curves through the stations of a passage, with a limited curvature.
#pragma once

#include <vug/passages/curves/curve.h>

namespace vug::passages {

struct SmoothOptions {
  double max_turn = 0.3;  ///< Radians from one piece of the curve to the next, approximately.
  /// The largest product of curvature and half the width. Sections of neighbouring pieces fold over
  /// each other at 1.
  double max_bend = 0.8;
};

/// The cubic Hermite curve through all points, whose tangents are those of curve.h, in pieces that
/// turn by at most `max_turn` and have at least a quarter of the section's size. Sizes change
/// smoothly. Points that are not fixed then move, by at most half of the smaller size, until bends
/// keep to `max_bend`; a bend that leaves no room for that remains sharper. Interior points that
/// are not fixed and lie within a sixth of the section of the point before are omitted.
Curve smoothed(const Curve& curve, const SmoothOptions& options);

/// The curvature of the curve at each point in 1/m, that of the circle through it and its
/// neighbours; 0 at the ends.
std::vector<double> curvatures(const Curve& curve);

}  // namespace vug::passages
