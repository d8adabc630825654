// The seam of cameras: from a place on the film to a ray.
#pragma once

#include <vug/render/vectors.h>

#include <array>
#include <memory>
#include <optional>

namespace vug::render {

/// What EXR's standard attributes worldToCamera and worldToNDC hold, row after row, for points as
/// rows: p * M. The camera looks along +z, x is right and y up (left-handed); NDC is (0, 0) at the
/// top left corner of the whole picture and (1, 1) at the bottom right, after the division by w.
struct CameraMatrices {
  std::array<float, 16> world_to_camera{}, world_to_ndc{};
};

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
  /// Of the view through the middle of the opening; none for views that matrices cannot tell.
  virtual std::optional<CameraMatrices> matrices(float aspect) const {
    (void)aspect;
    return std::nullopt;
  }
};
using CameraPtr = std::shared_ptr<const Camera>;

}  // namespace vug::render
