// SPDX-License-Identifier: Apache-2.0
// Solid fraction of the space around a point: the volume integral invariant, which distinguishes
// convex from concave regions at a chosen scale without derivatives of the surface (pottmann2007).
#pragma once

#include <vug/paint/paint.h>

namespace vug::paint {

/// Solid fraction of the ball of `radius` metres around the point: 1/2 on flat rock, 1/4 on a
/// right-angled edge, 1/8 on a cube's vertex, 3/4 and 7/8 in the corresponding concave corners. It
/// is read from the point's level set, whose values near the surface are true distances for any
/// field; 1/2 for a point without a level set. `radius` should be at least two voxels.
double solid_fraction(const EvalPoint& point, double radius);

}  // namespace vug::paint
