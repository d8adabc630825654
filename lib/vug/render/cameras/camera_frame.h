// Where a camera stands and how it is turned: what all kinds of cameras share.
#pragma once

#include <vug/base/schema.h>
#include <vug/base/transform.h>
#include <vug/render/camera.h>

#include <optional>
#include <string>

namespace vug::render {

struct CameraFrameParams {
  Vec3d eye{0, 0, 5};
  Vec3d target{0, 0, 0};
  Vec3d up{0, 1, 0};
  double shutter = 0;
  double shutter_open = 0;

  /// A sentence when they are no view; for the `fault` of a kind.
  std::string camera_frame_fault() const;
};

template <class P>
Schema<P>& describe_camera_frame(Schema<P>& s) {
  return s.param("eye", &P::eye, any_length("Where the camera stands."))
      .param("target", &P::target, any_length("What it looks at."))
      .param("up", &P::up, {.doc = "Which way is up in the picture."});
}
template <class P>
Schema<P>& describe_shutter(Schema<P>& s) {
  return s
      .param("shutter", &P::shutter,
             {.doc = "How long the shutter is open, in frames: 0.5 is a shutter of 180 degrees. "
                     "What moves meanwhile is blurred.",
              .min = 0,
              .max = 100})
      .param("shutter_open", &P::shutter_open,
             {.doc = "When it opens, in frames from the picture's own; -0.25 with a shutter of 0.5 "
                     "puts the picture in the middle.",
              .min = -100,
              .max = 100});
}

struct StereoParams {
  double interaxial = 0;
  std::optional<double> convergence;
};

template <class P>
Schema<P>& describe_stereo(Schema<P>& s) {
  return s
      .param("interaxial", &P::interaxial,
             {.doc = "Distance of the eyes, for a picture of two views; 0: one view. People's are "
                     "6.5cm apart.",
              .dimension = Dimension::length,
              .min = 0})
      .param("convergence", &P::convergence,
             positive_length("Distance of what both eyes see in the same place; when not given, "
                             "they look in parallel."));
}

/// The eye and three axes at right angles, each of unit length.
struct CameraFrame {
  explicit CameraFrame(const CameraFrameParams& p);

  Vec3f to_world(const Vec3f& local) const {
    return right * local.x + up * local.y + forward * local.z;
  }
  /// Of a point: how far to the right of the eye, above it and before it.
  Vec3f to_local(const Vec3f& point) const {
    const Vec3f d = point - eye;
    return {dot(d, right), dot(d, up), dot(d, forward)};
  }
  std::array<float, 16> world_to_camera() const;
  /// From where it looks along -z to the world.
  Transform transform() const;

  Vec3f eye, right, up, forward;
  Shutter shutter;
};

/// The matrix that first does `a`, then `b`, for points as rows.
std::array<float, 16> product(const std::array<float, 16>& a, const std::array<float, 16>& b);

}  // namespace vug::render
