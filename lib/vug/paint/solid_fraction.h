// How much of the space around a spot is solid: the volume integral invariant, which tells convex
// from concave at a chosen size and needs no derivatives of the surface (pottmann2007).
#pragma once

#include <vug/paint/paint.h>

namespace vug::paint {

/// The solid's share of the ball of `radius` metres around the spot: 1/2 on flat rock, 1/4 on a
/// right-angled edge, 1/8 on a cube's corner, 3/4 and 7/8 where these are hollow. Read from the
/// spot's level set, whose values near the surface are true distances whatever the field was;
/// 1/2 for a spot without one. `radius` should be two voxels or more.
double solid_fraction(const EvalPoint& point, double radius);

}  // namespace vug::paint
