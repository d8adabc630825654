// SPDX-License-Identifier: Apache-2.0
// Sections whose outline is a polygon: all families with walls that meet at corners or change along
// the height. Round parts are chains of short edges.
#pragma once

#include <vug/passages/section.h>

#include <vector>

namespace vug::passages {

/// The section with this outline: a simple polygon of at least three corners, counterclockwise,
/// with corners in metres; Error(bad_input) if it is not, or does not contain the origin. Convex
/// corners are rounded with the radius `rounding`, or a smaller one where edges are too short for
/// it: the polygon is moved inwards and the distance outwards. Polygons with a corner sharper than
/// about 30 degrees are not rounded. The distance to each edge and the winding number follow
/// quilez2008distance.
SectionPtr polygon_section(const std::vector<Vec2d>& outline, double rounding = 0);

/// Twice the signed area of a closed polygon; positive if counterclockwise.
double twice_area(const std::vector<Vec2d>& outline);

/// Appends `count` + 1 points of an ellipse about `centre` with half-axes `radii`, from angle
/// `from` to `to` in radians, both included.
void append_arc(std::vector<Vec2d>& outline, const Vec2d& centre, const Vec2d& radii, double from,
                double to, int count = 12);

}  // namespace vug::passages
