// SPDX-License-Identifier: Apache-2.0
// A look at a scene from an eye that its text need not have, and the motions of that eye.
#pragma once

#include <vug/base/vec.h>
#include <vug/render/camera.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::viewport {

/// An eye and the point around which it turns. The vertical is +Y.
struct View {
  Vec3d eye{0, 0, 5}, target{0, 0, 0};
  double fov = 1.2;  ///< Radians, as the `fov` of a perspective camera.

  bool operator==(const View& other) const {
    return eye == other.eye && target == other.target && fov == other.fov;
  }
};

/// The eye of a camera, and a target in the middle of its picture, 4 m away.
View view_of(const render::Camera& camera, double aspect);
/// A perspective camera.
render::CameraPtr camera_of(const View& view);

/// Turns the eye around the target by angles in radians; the elevation stays within 86 degrees.
View orbit(const View& view, double yaw, double pitch);
/// Moves eye and target in the plane of the picture, in units of their distance.
View pan(const View& view, double right, double up);
/// Multiplies the distance of the eye from the target.
View dolly(const View& view, double factor);
/// Moves the eye along its direction until the box fills the picture; the target is its centre.
View frame(const View& view, const Box3d& box);

/// The entries of a perspective camera with this view in a scene text: the key and the value.
std::vector<std::pair<std::string, std::string>> camera_entries(const View& view);
/// The declaration of a perspective camera with this view, for a scene text.
std::string camera_text(const View& view, const std::string& name);

}  // namespace vug::viewport
