// The seam of cameras: from a place on the film to a ray.
#pragma once

#include <vug/render/vectors.h>

#include <array>
#include <memory>
#include <optional>

namespace vug::exchange {
struct Camera;
}

namespace vug::render {

/// What EXR's standard attributes worldToCamera and worldToNDC hold, row after row, for points as
/// rows: p * M. The camera looks along +z, x is right and y up (left-handed); NDC is (0, 0) at the
/// top left corner of the whole picture and (1, 1) at the bottom right, after the division by w.
struct CameraMatrices {
  std::array<float, 16> world_to_camera{};
  std::optional<std::array<float, 16>> world_to_ndc;  ///< None where no matrix can tell.
};

/// When light reaches the film, in frames from the picture's own.
struct Shutter {
  double open = 0, close = 0;
  bool empty() const { return !(close > open); }
};

class Camera;
using CameraPtr = std::shared_ptr<const Camera>;

class Camera {
 public:
  virtual ~Camera() = default;
  /// `film`: (0, 0) is the top left corner of the picture, (1, 1) the bottom right. `aspect`:
  /// width over height; pixels are square. `lens`: two uniform numbers for the aperture.
  virtual Ray ray(const Vec2f& film, float aspect, const Vec2f& lens) const = 0;
  /// Where the picture shows a point, through the middle of the opening: the film's coordinates,
  /// beyond 0 and 1 where the picture ends before. Nothing for points that lie behind.
  virtual std::optional<Vec2f> project(const Vec3f& point, float aspect) const = 0;
  /// Of a picture that may go all round: after so many of its widths it begins anew; else 0.
  virtual float period() const { return 0; }
  /// Where the middle of the opening stands.
  virtual Vec3f position() const = 0;
  /// Depth of a point in metres: along the axis of view; for views all round its distance.
  virtual float depth(const Vec3f& point) const = 0;
  /// Of the view through the middle of the opening.
  virtual std::optional<CameraMatrices> matrices(float aspect) const {
    (void)aspect;
    return std::nullopt;
  }

  /// Fills in what files of other programs are told of it, but for its name and the picture's
  /// shape; false where they have no word for it.
  virtual bool as_data(exchange::Camera& camera) const { return (void)camera, false; }

  /// Empty: at one moment only.
  virtual Shutter shutter() const { return {}; }
  /// Of a camera for stereo: that of the left eye (-1) or of the right one (1); else null.
  virtual CameraPtr stereo_view(int side) const {
    (void)side;
    return nullptr;
  }

  /// Whether it moves while the shutter is open; then `ray` and `depth` are those of the middle of
  /// that time, and these of a `time` from 0, as it opens, to 1, as it closes.
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
