// Frames along a curve that do not turn about it: what tubes are swept with.
// A Frame is right-handed, tangent x normal = binormal, all of unit length. A turtle calls the
// three heading, left and up.
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
  /// Turned by an angle about an axis of unit length, by the right hand.
  Frame turned(const Vec3d& axis, double angle) const;
  /// As near to this as rounding lets it: tangent kept, the rest made square to it.
  Frame squared() const;
  bool operator==(const Frame&) const = default;
};

/// A frame with this tangent (any length above 0) whose normal is level; the x axis for a tangent
/// that is plumb.
Frame level_frame(const Vec3d& tangent);

/// v turned about an axis of unit length by the right hand (Rodrigues).
Vec3d turned(const Vec3d& v, const Vec3d& axis, double angle);

/// The frame at `to`, where the curve has the unit tangent `tangent`, from that at `from`, by two
/// reflections (table I of [@wang2008rotation]). One step of length h errs by O(h^5), a curve by
/// O(h^4).
Frame transported(const Frame& frame, const Vec3d& from, const Vec3d& to, const Vec3d& tangent);

/// The frame carried along the points, one for each, beginning with `first`, whose tangent is
/// tangents[0].
std::vector<Frame> rotation_minimising(const std::vector<Vec3d>& points,
                                       const std::vector<Vec3d>& tangents, const Frame& first);

}  // namespace vug
