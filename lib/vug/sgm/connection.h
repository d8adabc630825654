// SPDX-License-Identifier: Apache-2.0
// Internal to Growth: a shape that extends from one point to another, such as a passage between two
// rooms.
#pragma once

#include <vug/base/transform.h>
#include <vug/field/field.h>

namespace vug::sgm {

/// The solid cut across x in the middle of its bounds, with both halves moved apart by `length`
/// metres and the middle section in between: a sphere becomes a capsule, a box a longer box. Its
/// middle is the origin. Values are lower bounds of the distance. The bounds must be finite.
field::Field elongated(const field::Field& field, double length);

/// The map of the elongated solid to the segment from `a` to `b`: x points from a to b, y up, or to
/// the side if the segment is vertical. The points must differ.
Transform frame_between(const Vec3d& a, const Vec3d& b);

}  // namespace vug::sgm
