// SPDX-License-Identifier: Apache-2.0
#include <vug/render/cameras/camera_frame.h>

namespace vug::render {

std::string CameraFrameParams::camera_frame_fault() const {
  const Vec3d forward = target - eye;
  if (!(forward.length() > 0)) return "the camera's eye and target are the same point";
  if (!(forward.cross(up).length() > 1e-9 * forward.length() * up.length()))
    return "the camera's up direction is its direction of view";
  return {};
}

CameraFrame::CameraFrame(const CameraFrameParams& p) {
  const Vec3d ahead = (p.target - p.eye).normalized();
  const Vec3d aside = ahead.cross(p.up).normalized();
  eye = Vec3f(p.eye);
  forward = Vec3f(ahead);
  right = Vec3f(aside);
  up = Vec3f(aside.cross(ahead));
  shutter = {p.shutter_open, p.shutter_open + p.shutter};
}

std::array<float, 16> CameraFrame::world_to_camera() const {
  std::array<float, 16> m{};
  const Vec3f axes[] = {right, up, forward};
  for (size_t column = 0; column < 3; ++column) {
    const Vec3f& axis = axes[column];
    m[column] = axis.x;
    m[4 + column] = axis.y;
    m[8 + column] = axis.z;
    m[12 + column] = -dot(axis, eye);
  }
  m[15] = 1;
  return m;
}

Transform CameraFrame::transform() const {
  return {Vec3d(right), Vec3d(up), -Vec3d(forward), Vec3d(eye)};
}

std::array<float, 16> product(const std::array<float, 16>& a, const std::array<float, 16>& b) {
  std::array<float, 16> out{};
  for (size_t row = 0; row < 4; ++row)
    for (size_t column = 0; column < 4; ++column)
      for (size_t k = 0; k < 4; ++k) out[4 * row + column] += a[4 * row + k] * b[4 * k + column];
  return out;
}

}  // namespace vug::render
