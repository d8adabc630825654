// SPDX-License-Identifier: Apache-2.0
// Frames of sections along a passage: upright where it is level, without needless rotation where it
// is steep.
#pragma once

#include <vug/base/vec.h>

#include <vector>

namespace vug::passages {

/// The directions of u and v, perpendicular unit vectors across the passage.
struct Frame {
  Vec3d right{1, 0, 0};
  Vec3d up{0, 1, 0};
};

/// Frames for the points of a curve and its unit tangents. Where the tangent is less steep than 50
/// degrees `right` is horizontal; above 70 degrees the frame is the one before without rotation
/// about the tangent (double reflection, wang2008rotation); in between it turns gradually.
std::vector<Frame> frames(const std::vector<Vec3d>& points, const std::vector<Vec3d>& tangents);

}  // namespace vug::passages
