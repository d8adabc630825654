// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/handle_drag.h>

#include <algorithm>
#include <cmath>

namespace vug::workbench {
namespace {

using language::HandleRole;
using language::LiteralHandle;
using viewport::PixelRay;
using viewport::ScreenView;

/// Share of a pixel that rounding of a number may move a handle.
constexpr double kPixelShare = 0.1;

double arrow_length(const LiteralHandle& handle, const ScreenView& view) {
  return kHandlePixels * view.pixel_size(handle.position());
}

/// The point of a ray in the plane through a point across the ray that leads to it.
std::optional<Vec3d> in_plane(const PixelRay& ray, const Vec3d& point, const Vec3d& normal) {
  const double slope = ray.direction.dot(normal);
  if (!(slope > 1e-6)) return std::nullopt;
  return ray.origin + ray.direction * ((point - ray.origin).dot(normal) / slope);
}

/// The point of a sphere that a ray hits nearest to a point; beyond the rim, the one nearest to the
/// ray.
Vec3d on_sphere(const PixelRay& ray, const Vec3d& center, double radius, const Vec3d& near) {
  const double middle = (center - ray.origin).dot(ray.direction);
  const Vec3d closest = ray.origin + ray.direction * middle;
  const double inside = radius * radius - (closest - center).length2();
  if (inside <= 0) return closest;
  const Vec3d half = ray.direction * std::sqrt(inside);
  const Vec3d front = closest - half, back = closest + half;
  return (front - near).length2() <= (back - near).length2() ? front : back;
}

/// The change of a number along a line through the grip, in units of the number.
std::optional<double> along(const LiteralHandle& handle, const Vec3d& axis, const ScreenView& view,
                            const Vec2d& target) {
  return viewport::nearest_on_line(grip_point(handle, view), handle.place.vector(axis),
                                   view.ray(target));
}

std::vector<double> numbers_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

}  // namespace

Vec3d arrow_tip(const LiteralHandle& handle, const ScreenView& view) {
  const Vec3d direction = handle.place.vector(handle.vector());
  if (!(direction.length() > 0)) return handle.position();
  return handle.position() + direction.normalized() * arrow_length(handle, view);
}

Vec3d grip_point(const LiteralHandle& handle, const ScreenView& view) {
  return handle.role == HandleRole::direction ? arrow_tip(handle, view) : handle.position();
}

std::optional<std::vector<double>> dragged_numbers(const LiteralHandle& handle,
                                                   const ScreenView& view, const Vec2d& offset,
                                                   std::optional<int> axis) {
  const Vec3d grip = grip_point(handle, view);
  const std::optional<Vec2d> pixel = view.project(grip);
  if (!pixel) return std::nullopt;
  const PixelRay target = view.ray(*pixel + offset);
  if (handle.role == HandleRole::length || handle.role == HandleRole::extent) {
    const auto change = along(handle, handle.axis * handle.share, view, *pixel + offset);
    if (!change) return std::nullopt;
    return std::vector<double>{std::max(handle.numbers[0].value + *change, handle.least)};
  }
  if (handle.role == HandleRole::direction) {
    const double radius = arrow_length(handle, view);
    if (!(radius > 0)) return std::nullopt;
    const Vec3d tip = on_sphere(target, handle.position(), radius, grip) - handle.position();
    const Vec3d local = handle.place.inverse().vector(tip);
    if (!(local.length() > 0)) return std::nullopt;
    return numbers_of(local.normalized() * handle.vector().length());
  }
  if (axis) {
    Vec3d unit(0, 0, 0);
    unit[*axis] = 1;
    const auto change = along(handle, unit, view, *pixel + offset);
    if (!change) return std::nullopt;
    return numbers_of(handle.vector() + unit * *change);
  }
  const auto moved = in_plane(target, grip, view.ray(*pixel).direction);
  if (!moved) return std::nullopt;
  return numbers_of(handle.place.inverse().point(*moved));
}

double number_step(const LiteralHandle& handle, const ScreenView& view) {
  if (handle.role == HandleRole::direction)
    return kPixelShare / kHandlePixels * handle.vector().length();
  const double stretch = handle.place.max_stretch() * handle.share;
  return kPixelShare * view.pixel_size(handle.position()) / stretch;
}

}  // namespace vug::workbench
