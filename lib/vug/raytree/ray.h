// SPDX-License-Identifier: Apache-2.0
// Rays and the vector operations that ray tracing needs. Single precision.
#pragma once

#include <vug/base/vec.h>

#include <cmath>
#include <limits>

namespace vug::raytree {

/// A distance beyond everything.
inline constexpr float kFar = std::numeric_limits<float>::infinity();

inline float dot(const Vec3f& a, const Vec3f& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3f cross(const Vec3f& a, const Vec3f& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vec3f& v) { return std::sqrt(dot(v, v)); }
inline Vec3f normalized(const Vec3f& v) { return v * (1.0f / length(v)); }

struct Ray {
  Vec3f origin;
  Vec3f direction;   ///< Unit length.
  float spread = 0;  ///< For camera rays: the angle subtended by a pixel, in radians.

  Vec3f at(float t) const { return origin + direction * t; }
};

}  // namespace vug::raytree
