// SPDX-License-Identifier: Apache-2.0
// The place, direction and lens of a camera that stands upright.
#pragma once

#include <vug/base/vec.h>
#include <vug/render/camera.h>

#include <string>

namespace vug::scout {

/// Radians in a degree.
inline constexpr double kDegree = kPi / 180;

struct Pose {
  Vec3d eye{0.0};
  double azimuth = 0;  ///< Radians; 0 looks along +x, a quarter turn along +z.
  double pitch = 0;    ///< Radians above the horizon.
  double fov = 1.1;    ///< Horizontal angle of view in radians.
};

/// The unit direction of the view.
Vec3d view_direction(const Pose& pose);

/// The same pose with its numbers rounded to those of shot_text: centimetres, and the target that
/// is written there.
Pose rounded(const Pose& pose);

/// A point on the view axis, 5 m away, rounded to centimetres.
Vec3d target_of(const Pose& pose);

/// "(1.25, 0.7, -3)": a point in scenes, rounded to centimetres.
std::string point_text(const Vec3d& p);

/// The perspective camera of the pose.
render::CameraPtr camera_of(const Pose& pose);

/// The smallest angle between two azimuths, in radians, from 0 to pi.
double azimuth_between(double a, double b);

}  // namespace vug::scout
