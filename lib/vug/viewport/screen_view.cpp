// SPDX-License-Identifier: Apache-2.0
#include <vug/viewport/screen_view.h>

namespace vug::viewport {

std::optional<Vec2d> ScreenView::project(const Vec3d& point) const {
  const auto film = camera->project(Vec3f(point), static_cast<float>(width / height));
  if (!film) return std::nullopt;
  return Vec2d(static_cast<double>(film->x) * width, static_cast<double>(film->y) * height);
}

PixelRay ScreenView::ray(const Vec2d& pixel) const {
  const Vec2f film(static_cast<float>(pixel.x / width), static_cast<float>(pixel.y / height));
  const render::Ray ray = camera->ray(film, static_cast<float>(width / height), {0.5f, 0.5f});
  return {Vec3d(ray.origin), Vec3d(ray.direction).normalized()};
}

double ScreenView::pixel_size(const Vec3d& point) const {
  const std::optional<Vec2d> pixel = project(point);
  if (!pixel) return 0;
  const PixelRay next = ray(*pixel + Vec2d(1, 0));
  const Vec3d to_point = point - next.origin;
  return (to_point - next.direction * to_point.dot(next.direction)).length();
}

std::optional<double> nearest_on_line(const Vec3d& origin, const Vec3d& direction,
                                      const PixelRay& ray) {
  const Vec3d offset = origin - ray.origin;
  const double square = direction.dot(direction), mixed = direction.dot(ray.direction);
  const double determinant = square - mixed * mixed;
  if (!(determinant > 1e-4 * square)) return std::nullopt;
  return (mixed * ray.direction.dot(offset) - direction.dot(offset)) / determinant;
}

}  // namespace vug::viewport
