// SPDX-License-Identifier: Apache-2.0
#include <vug/base/vec.h>
#include <vug/render/cameras/pixel_size.h>

#include <algorithm>
#include <limits>

namespace vug::render {
namespace {

/// The distance from a point to a ray, which continues to both sides.
double distance_to(const Ray& ray, const Vec3d& point) {
  return Vec3d(ray.direction).cross(point - Vec3d(ray.origin)).length();
}

}  // namespace

PixelSize::PixelSize(std::vector<CameraPtr> cameras, const PictureSize& picture, double off_screen)
    : cameras_(std::move(cameras)),
      width_(static_cast<float>(picture.width)),
      height_(static_cast<float>(picture.height)),
      off_screen_(off_screen) {}

double PixelSize::seen_by(const Camera& camera, const Vec3f& point) const {
  const float aspect = width_ / height_;
  const Vec2f middle(0.5f, 0.5f);
  const std::optional<Vec2f> projected = camera.project(point, aspect);
  Vec2f film = projected.value_or(middle);
  film = {std::clamp(film.x, 0.0f, 1.0f), std::clamp(film.y, 0.0f, 1.0f)};
  const Ray ray = camera.ray(film, aspect, middle);
  const double distance = (Vec3d(point) - Vec3d(ray.origin)).length();
  // Neighbours towards the middle, so that they are inside the picture.
  const Vec2f right = film + Vec2f(film.x > 0.5f ? -1 / width_ : 1 / width_, 0.0f);
  const Vec2f below = film + Vec2f(0.0f, film.y > 0.5f ? -1 / height_ : 1 / height_);
  const Vec3d at = Vec3d(ray.origin) + Vec3d(ray.direction) * distance;
  const double pixel = std::min(distance_to(camera.ray(right, aspect, middle), at),
                                distance_to(camera.ray(below, aspect, middle), at));
  const double sine =
      !projected ? 1 : std::min(1.0, distance_to(ray, Vec3d(point)) / std::max(distance, 1e-9));
  return pixel * (1 + (off_screen_ - 1) * sine);
}

double PixelSize::at(const Vec3d& point) const {
  double smallest = std::numeric_limits<double>::max();
  for (const CameraPtr& camera : cameras_)
    smallest = std::min(smallest, seen_by(*camera, Vec3f(point)));
  return smallest;
}

}  // namespace vug::render
