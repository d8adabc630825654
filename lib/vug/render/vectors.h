// SPDX-License-Identifier: Apache-2.0
// Vector, colour and frame helpers of the renderer. Single precision; colours are linear Rec.709.
#pragma once

#include <vug/raytree/ray.h>

#include <cmath>

namespace vug::render {

using raytree::cross;
using raytree::dot;
using raytree::kFar;
using raytree::length;
using raytree::normalized;
using raytree::Ray;

/// Red, green and blue of a radiance (W/sr/m^2), a throughput or a reflectance.
using Rgb = Vec3f;

inline constexpr float kPif = 3.14159265f;

inline float largest(const Rgb& c) { return std::fmax(c.x, std::fmax(c.y, c.z)); }
/// True if the vector defines a direction: its length is finite and greater than 0.
inline bool is_direction(const Vec3d& v) {
  const double size = v.length();
  return size > 0 && std::isfinite(size);
}
inline bool is_black(const Rgb& c) { return !(c.x > 0 || c.y > 0 || c.z > 0); }
/// Relative luminance of linear Rec.709 (ITU-R BT.709).
inline float luminance(const Rgb& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
inline double luminance(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

/// Right-handed orthonormal axes around a unit z: Duff et al. 2017, "Building an orthonormal
/// basis, revisited" (cite duff2017basis).
struct Frame {
  Vec3f x, y, z;

  explicit Frame(const Vec3f& n) : z(n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z), b = n.x * n.y * a;
    x = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }
  Vec3f to_world(const Vec3f& v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3f to_local(const Vec3f& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

}  // namespace vug::render
