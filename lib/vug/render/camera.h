// SPDX-License-Identifier: Apache-2.0
// Interface of cameras: maps a film position to a ray.
#pragma once

#include <vug/render/vectors.h>

#include <array>
#include <memory>
#include <optional>

namespace vug::exchange {
struct Camera;
}

namespace vug::render {

/// The values of EXR's standard attributes worldToCamera and worldToNDC, row by row, for points as
/// row vectors: p * M. The camera looks along +z, x points right and y up (left-handed); NDC is
/// (0, 0) at the top left corner of the whole picture and (1, 1) at the bottom right, after the
/// division by w.
struct CameraMatrices {
  std::array<float, 16> world_to_camera{};
  std::optional<std::array<float, 16>> world_to_ndc;  ///< None if the projection is not a matrix.
};

/// The exposure interval, in frames relative to the picture's own.
struct Shutter {
  double open = 0, close = 0;
  bool empty() const { return !(close > open); }
};

class Camera;
using CameraPtr = std::shared_ptr<const Camera>;

class Camera {
 public:
  virtual ~Camera() = default;
  /// `film`: (0, 0) is the top left corner of the picture, (1, 1) the bottom right. `aspect`: width
  /// over height; pixels are square. `lens`: two uniform numbers for the aperture.
  virtual Ray ray(const Vec2f& film, float aspect, const Vec2f& lens) const = 0;
  /// Projects a point through the centre of the aperture to film coordinates, below 0 or above 1
  /// outside the picture. None for points behind the camera.
  virtual std::optional<Vec2f> project(const Vec3f& point, float aspect) const = 0;
  /// For cameras that may cover 360 degrees: the film coordinate at which the picture repeats, in
  /// picture widths; otherwise 0.
  virtual float period() const { return 0; }
  /// Centre of the aperture.
  virtual Vec3f position() const = 0;
  /// Depth of a point in metres: along the viewing axis, or the distance for panoramic cameras.
  virtual float depth(const Vec3f& point) const = 0;
  /// Matrices of the projection through the centre of the aperture.
  virtual std::optional<CameraMatrices> matrices(float aspect) const {
    (void)aspect;
    return std::nullopt;
  }

  /// Fills in the description for exporters, except its name and the aspect ratio; false if the
  /// camera has no equivalent there.
  virtual bool as_data(exchange::Camera& camera) const { return (void)camera, false; }

  /// Empty: a single instant.
  virtual Shutter shutter() const { return {}; }
  /// For stereo cameras: the camera of the left eye (-1) or the right eye (1); otherwise null.
  virtual CameraPtr stereo_view(int side) const {
    (void)side;
    return nullptr;
  }

  /// True if it moves while the shutter is open. Then `ray` and `depth` refer to the middle of the
  /// exposure, and the two functions below to a `time` from 0 (shutter opens) to 1 (shutter
  /// closes).
  virtual bool moves() const { return false; }
  virtual Ray ray_at(float time, const Vec2f& film, float aspect, const Vec2f& lens) const {
    (void)time;
    return ray(film, aspect, lens);
  }
  virtual float depth_at(float time, const Vec3f& point) const {
    (void)time;
    return depth(point);
  }
};

}  // namespace vug::render
