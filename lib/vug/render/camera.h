// The seam of cameras: from a place on the film to a ray.
#pragma once

#include <vug/render/vectors.h>

#include <memory>

namespace vug::render {

class Camera {
 public:
  virtual ~Camera() = default;
  /// `film`: (0, 0) is the top left corner of the picture, (1, 1) the bottom right. `aspect`:
  /// width over height; pixels are square. `lens`: two uniform numbers for the aperture.
  virtual Ray ray(const Vec2f& film, float aspect, const Vec2f& lens) const = 0;
  /// Where the middle of the opening stands.
  virtual Vec3f eye() const = 0;
  /// Depth of a point: its distance from the eye along the axis of view (metres).
  virtual float depth(const Vec3f& point) const = 0;
};
using CameraPtr = std::shared_ptr<const Camera>;

}  // namespace vug::render
