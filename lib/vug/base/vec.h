// SPDX-License-Identifier: Apache-2.0
// Vectors, boxes and matrices: aliases of Imath types.
// World space is in metres, right-handed, y up; index space has its own types in volume/.
#pragma once

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <limits>

namespace vug {

template <class T>
using Vec3 = Imath::Vec3<T>;
using Vec2d = Imath::V2d;
using Vec2f = Imath::V2f;
using Vec2i = Imath::V2i;
using Vec3d = Imath::V3d;
using Vec3f = Imath::V3f;
using Vec3i = Imath::V3i;
using Mat44d = Imath::M44d;
using Box3d = Imath::Box3d;
using Box3f = Imath::Box3f;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kPi = 3.14159265358979323846;

/// The box that contains all of space.
inline Box3d infinite_box() { return {Vec3d(-kInfinity), Vec3d(kInfinity)}; }

/// True if every corner is finite and the box contains at least one point.
bool is_finite(const Box3d& box);

/// `box` expanded by `amount` on every side; an empty box stays empty.
Box3d grown(const Box3d& box, double amount);

/// The intersection of two boxes; empty (min > max) if they do not overlap.
Box3d intersection(const Box3d& a, const Box3d& b);

/// The smallest box that contains both.
Box3d united(const Box3d& a, const Box3d& b);

/// Squared distance from a point to a box; 0 inside.
inline double squared_distance(const Vec3d& p, const Box3d& box) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = box.min[axis] - p[axis];
    const double above = p[axis] - box.max[axis];
    const double out = below > above ? below : above;
    if (out > 0) sum += out * out;
  }
  return sum;
}

}  // namespace vug
