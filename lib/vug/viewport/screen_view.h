// SPDX-License-Identifier: Apache-2.0
// Points of a scene as pixels of its picture, and pixels as rays.
#pragma once

#include <vug/base/vec.h>
#include <vug/render/camera.h>

#include <optional>

namespace vug::viewport {

/// A half-line; `direction` is unit.
struct PixelRay {
  Vec3d origin, direction;
};

/// Pixels count from the top left corner of the picture, in fractions.
struct ScreenView {
  render::CameraPtr camera;
  double width = 1, height = 1;  ///< Pixels.

  /// The pixel of a point, also outside of the picture; nothing behind the camera.
  std::optional<Vec2d> project(const Vec3d& point) const;
  PixelRay ray(const Vec2d& pixel) const;
  /// The size of a pixel at a point, in metres; 0 behind the camera.
  double pixel_size(const Vec3d& point) const;
};

/// The position on a line at which it is nearest to a ray, in units of `direction`; nothing if both
/// are nearly parallel.
std::optional<double> nearest_on_line(const Vec3d& origin, const Vec3d& direction,
                                      const PixelRay& ray);

}  // namespace vug::viewport
