// SPDX-License-Identifier: Apache-2.0
// The size of a pixel at points of a scene, as seen by one or several cameras, for level of detail.
#pragma once

#include <vug/render/camera.h>

#include <vector>

namespace vug::render {

/// The size of the whole picture in pixels.
struct PictureSize {
  int width = 1, height = 1;
};

class PixelSize {
 public:
  /// All cameras see pictures of the same size: the two eyes of a stereo camera, or one camera at
  /// several times. `off_screen`, at least 1: the factor for points behind the camera and at right
  /// angles to the edge of the picture.
  PixelSize(std::vector<CameraPtr> cameras, const PictureSize& picture, double off_screen);

  /// Edge in metres of the smallest pixel that covers the point, in any of the cameras. Outside
  /// the picture it is that of the nearest edge, times 1 + (off_screen - 1) s, where s is the sine
  /// of the angle between the point and the edge.
  double at(const Vec3d& point) const;

 private:
  double seen_by(const Camera& camera, const Vec3f& point) const;

  std::vector<CameraPtr> cameras_;
  float width_, height_;
  double off_screen_;
};

}  // namespace vug::render
