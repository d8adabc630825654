// SPDX-License-Identifier: Apache-2.0
// Rotation-minimizing frames along a curve, used for sweeping tubes.
// A Frame is right-handed and orthonormal: tangent x normal = binormal. A turtle's heading, left
// and up are the tangent, normal and binormal.
#pragma once

#include <vug/base/vec.h>

#include <vector>

namespace vug {

struct Frame {
  Vec3d tangent{0, 1, 0};
  Vec3d normal{1, 0, 0};
  Vec3d binormal{0, 0, -1};

  /// The direction at an angle from the normal towards the binormal, in radians.
  Vec3d around(double angle) const;
  /// Rotated by an angle in radians about an axis of unit length (right-hand rule).
  Frame rotated(const Vec3d& axis, double angle) const;
  /// The nearest orthonormal frame with the same tangent direction: removes rounding errors.
  Frame orthonormalized() const;
  bool operator==(const Frame&) const = default;
};

/// A frame with this tangent (any length above 0) whose normal is horizontal; for a vertical
/// tangent the normal is the x axis.
Frame level_frame(const Vec3d& tangent);

/// v rotated by an angle in radians about an axis of unit length (Rodrigues' formula, right-hand
/// rule).
Vec3d rotated(const Vec3d& v, const Vec3d& axis, double angle);

/// The frame at `from`, transported to `to`, where the curve has the unit tangent `tangent`, by the
/// double reflection method (table I of [@wang2008rotation]). The error is O(h^5) for a step of
/// length h and O(h^4) for a curve.
Frame transported(const Frame& frame, const Vec3d& from, const Vec3d& to, const Vec3d& tangent);

/// The rotation-minimizing frame at each point, starting with `first`, whose tangent is
/// tangents[0].
std::vector<Frame> rotation_minimising(const std::vector<Vec3d>& points,
                                       const std::vector<Vec3d>& tangents, const Frame& first);

}  // namespace vug
