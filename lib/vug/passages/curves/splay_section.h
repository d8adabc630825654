// SPDX-License-Identifier: Apache-2.0
// Sections from splays: the outline that is star-shaped about the station and passes through the
// measured points of the walls.
#pragma once

#include <vug/passages/curves/frames.h>
#include <vug/passages/curves/walls.h>
#include <vug/passages/section.h>

#include <vector>

namespace vug::passages {

/// The section about a station from its splays, projected into the plane across `tangent`; null if
/// fewer than four of them, in at least three quarters of the circle, are usable. Splays within 45
/// degrees of the tangent, or longer than three times the median of the usable ones, are not used.
/// The radius between two hits at most 90 degrees apart is a monotone cubic in the angle; larger
/// gaps are closed with the ellipse of the walls.
SectionPtr splay_section(const std::vector<Vec3d>& splays, const Vec3d& station, const Frame& frame,
                         const Walls& walls);

}  // namespace vug::passages
