// Small vector helpers of the renderer. Single precision; colours are linear Rec.709.
#pragma once

#include <vug/base/vec.h>

#include <cmath>

namespace vug::render {

/// Radiance (W/sr/m^2), throughput or reflectance, a value for each of red, green, blue.
using Rgb = Vec3f;

inline constexpr float kPif = 3.14159265f;
inline constexpr float kFar = std::numeric_limits<float>::infinity();

inline float dot(const Vec3f& a, const Vec3f& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3f cross(const Vec3f& a, const Vec3f& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vec3f& v) { return std::sqrt(dot(v, v)); }
inline Vec3f normalized(const Vec3f& v) { return v * (1.0f / length(v)); }
inline float largest(const Rgb& c) { return std::fmax(c.x, std::fmax(c.y, c.z)); }
/// It tells a direction: it is neither zero nor beyond all numbers.
inline bool is_direction(const Vec3d& v) {
  const double size = v.length();
  return size > 0 && std::isfinite(size);
}
inline bool is_black(const Rgb& c) { return !(c.x > 0 || c.y > 0 || c.z > 0); }
/// Relative luminance of linear Rec.709 (ITU-R BT.709).
inline float luminance(const Rgb& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
inline double luminance(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

struct Ray {
  Vec3f origin;
  Vec3f direction;   ///< Unit length.
  float spread = 0;  ///< Of a camera's ray: the angle across a pixel, radians.

  Vec3f at(float t) const { return origin + direction * t; }
};

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
