// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/kinds.h>
#include <vug/scout/pose.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::scout {
namespace {

constexpr double kTargetDistance = 5;

double centimetres(double x) { return std::round(x * 100) / 100 + 0.0; }  // no -0

Vec3d centimetres(const Vec3d& p) { return {centimetres(p.x), centimetres(p.y), centimetres(p.z)}; }

}  // namespace

Vec3d view_direction(const Pose& pose) {
  const double level = maths::cos(pose.pitch);
  return {level * maths::cos(pose.azimuth), maths::sin(pose.pitch),
          level * maths::sin(pose.azimuth)};
}

Vec3d target_of(const Pose& pose) {
  return centimetres(pose.eye + view_direction(pose) * kTargetDistance);
}

std::string point_text(const Vec3d& p) {
  const Vec3d at = centimetres(p);
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", at.x, at.y, at.z);
}

Pose rounded(const Pose& pose) {
  Pose out;
  out.eye = centimetres(pose.eye);
  const Vec3d way = target_of(pose) - out.eye;
  out.azimuth = maths::atan2(way.z, way.x);
  out.pitch = maths::atan2(way.y, std::sqrt(way.x * way.x + way.z * way.z));
  out.fov = std::round(pose.fov / kDegree) * kDegree;
  return out;
}

render::CameraPtr camera_of(const Pose& pose) {
  return render::make_camera("perspective", {{"eye", pose.eye},
                                             {"target", pose.eye + view_direction(pose)},
                                             {"fov", Number{pose.fov, Dimension::angle}}});
}

double azimuth_between(double a, double b) { return std::fabs(std::remainder(a - b, 2 * kPi)); }

}  // namespace vug::scout
