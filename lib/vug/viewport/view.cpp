// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/kinds.h>
#include <vug/viewport/view.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::viewport {
namespace {

constexpr double kMaxElevation = 1.5;    // radians
constexpr double kMinDistance = 1e-3;    // metres
constexpr double kTargetDistance = 4.0;  // metres; a camera has no target

Vec3d offset_of(const View& view) {
  const Vec3d offset = view.eye - view.target;
  return offset.length() > kMinDistance ? offset : Vec3d(0, 0, kMinDistance);
}

}  // namespace

View view_of(const render::Camera& camera, double aspect) {
  const auto direction = [&](float x) {
    return Vec3d(camera.ray({x, 0.5f}, static_cast<float>(aspect), {0.5f, 0.5f}).direction)
        .normalized();
  };
  View view;
  view.eye = Vec3d(camera.position());
  view.target = view.eye + direction(0.5f) * kTargetDistance;
  const double cosine = std::min(1.0, direction(0.5f).dot(direction(0)));
  view.fov = std::min(2 * maths::acos(cosine), 2.8);
  return view;
}

render::CameraPtr camera_of(const View& view) {
  return render::make_camera(
      "perspective",
      {{"eye", view.eye}, {"target", view.target}, {"fov", render::radians(view.fov)}});
}

View orbit(const View& view, double yaw, double pitch) {
  const Vec3d offset = offset_of(view);
  const double reach = offset.length();
  const double flat = std::sqrt(offset.x * offset.x + offset.z * offset.z);
  const double angle = maths::atan2(offset.x, offset.z) - yaw;
  const double elevation =
      std::clamp(maths::atan2(offset.y, flat) + pitch, -kMaxElevation, kMaxElevation);
  const double width = maths::cos(elevation);
  View out = view;
  out.eye =
      view.target +
      Vec3d(maths::sin(angle) * width, maths::sin(elevation), maths::cos(angle) * width) * reach;
  return out;
}

View pan(const View& view, double right, double up) {
  const Vec3d offset = offset_of(view);
  const double reach = offset.length();
  const Vec3d flat(offset.z, 0, -offset.x);
  const Vec3d side = flat.length() > 0 ? flat.normalized() : Vec3d(1, 0, 0);
  const Vec3d upward = offset.cross(side).normalized();
  const Vec3d move = (side * right + upward * up) * reach;
  View out = view;
  out.eye += move, out.target += move;
  return out;
}

View dolly(const View& view, double factor) {
  View out = view;
  const Vec3d offset = offset_of(view);
  out.eye = view.target + offset.normalized() * std::max(kMinDistance, offset.length() * factor);
  return out;
}

View frame(const View& view, const Box3d& box) {
  if (box.isEmpty()) return view;
  View out = view;
  out.target = box.center();
  const double reach = 0.5 * box.size().length() / maths::sin(std::min(view.fov, 2.0) / 2);
  out.eye = out.target + offset_of(view).normalized() * std::max(reach, kMinDistance);
  return out;
}

std::vector<std::pair<std::string, std::string>> camera_entries(const View& view) {
  const auto point = [](const Vec3d& p) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z);
  };
  return {{"eye", point(view.eye)},
          {"target", point(view.target)},
          {"fov", fmt::format("{:.0f}deg", view.fov * 180 / kPi)}};
}

std::string camera_text(const View& view, const std::string& name) {
  std::string entries;
  for (const auto& [key, value] : camera_entries(view))
    entries += fmt::format("{}{} {}", entries.empty() ? "" : "  ", key, value);
  return fmt::format("camera {} {{ {} }}", name, entries);
}

}  // namespace vug::viewport
