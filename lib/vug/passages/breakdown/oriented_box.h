// SPDX-License-Identifier: Apache-2.0
// Boxes in any orientation, and the exact height at which one falls onto another.
#pragma once

#include <vug/base/vec.h>
#include <vug/passages/water/polytopes.h>

#include <array>

namespace vug::passages {

/// A rectangular block of rock.
struct OrientedBox {
  Vec3d centre{0.0};
  Vec3d half{0.5};  ///< Half the size along each axis, metres.
  std::array<Vec3d, 3> axes{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};  ///< Unit vectors.

  double volume() const { return 8 * half.x * half.y * half.z; }
  /// Half the extent along a unit vector.
  double extent(const Vec3d& direction) const;
  Box3d bounds() const;
  /// A corner; each sign is -1 or 1.
  Vec3d corner(double x, double y, double z) const {
    return centre + axes[0] * (x * half.x) + axes[1] * (y * half.y) + axes[2] * (z * half.z);
  }
  Polytope polytope() const;
  /// Turned about its centre by an angle in radians about a unit vector.
  OrientedBox turned(const Vec3d& axis, double angle) const;
};

/// The height of the falling box's centre at which it first touches the other when it comes from
/// above; -infinity if it passes. By the separating axis theorem (gottschalk1996), two boxes are
/// disjoint exactly if one of 15 axes separates them; along a vertical line, each axis separates
/// outside of an interval.
double landing_height(const OrientedBox& falling, const OrientedBox& other);

/// The depth by which two boxes overlap: the least over the 15 axes, negative if they are disjoint
/// (at most the distance in magnitude).
double overlap_depth(const OrientedBox& a, const OrientedBox& b);

}  // namespace vug::passages
