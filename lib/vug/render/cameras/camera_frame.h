// SPDX-License-Identifier: Apache-2.0
// Position, orientation, shutter and stereo parameters shared by all kinds of cameras.
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

  /// Describes a degenerate frame; empty if it is valid. For the `fault` of a kind.
  std::string camera_frame_fault() const;
};

template <class P>
Schema<P>& describe_camera_frame(Schema<P>& s) {
  return s.param("eye", &P::eye, any_length("Position of the camera."))
      .param("target", &P::target, any_length("Point at which the camera looks."))
      .param("up", &P::up, {.doc = "Up direction of the picture."});
}
template <class P>
Schema<P>& describe_shutter(Schema<P>& s) {
  return s
      .param("shutter", &P::shutter,
             {.doc = "Exposure time in frames; 0.5 is a 180-degree shutter. Objects that move "
                     "meanwhile are blurred.",
              .min = 0,
              .max = 100})
      .param(
          "shutter_open", &P::shutter_open,
          {.doc = "Opening time in frames, relative to the picture's own; -0.25 with a shutter of "
                  "0.5 centres the exposure.",
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
      .param(
          "interaxial", &P::interaxial,
          {.doc = "Distance between the eyes of a stereo picture; 0: a single view. Human eyes are "
                  "6.5cm apart.",
           .dimension = Dimension::length,
           .min = 0})
      .param("convergence", &P::convergence,
             positive_length(
                 "Distance at which both eyes see a point at the same position; by default the "
                 "eyes look in parallel."));
}

/// The camera position and three orthonormal axes.
struct CameraFrame {
  explicit CameraFrame(const CameraFrameParams& p);

  Vec3f to_world(const Vec3f& local) const {
    return right * local.x + up * local.y + forward * local.z;
  }
  /// Coordinates of a point relative to the camera: right, up and forward.
  Vec3f to_local(const Vec3f& point) const {
    const Vec3f d = point - eye;
    return {dot(d, right), dot(d, up), dot(d, forward)};
  }
  std::array<float, 16> world_to_camera() const;
  /// Camera-to-world transform for cameras that look along -z.
  Transform transform() const;

  Vec3f eye, right, up, forward;
  Shutter shutter;
};

/// The matrix that applies `a`, then `b`, for points as row vectors.
std::array<float, 16> product(const std::array<float, 16>& a, const std::array<float, 16>& b);

}  // namespace vug::render
