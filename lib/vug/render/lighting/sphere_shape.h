// SPDX-License-Identifier: Apache-2.0
// Spheres as seen from a point: the shape of sphere, spot and measured lights.
#pragma once

#include <vug/render/light.h>

namespace vug::render {

/// Visible from outside. Sampled by the cone that it subtends (Shirley, Wang, Zimmerman 1996,
/// "Monte Carlo techniques for direct lighting calculations", cite shirley1996direct).
class SphereShape {
 public:
  SphereShape(const Vec3d& center, double radius)
      : center_(center), radius_(static_cast<float>(radius)) {}

  /// Sets direction, distance and pdf; leaves radiance unchanged. The pdf is 0 inside the sphere.
  LightSample sample(const Vec3f& point, const Vec2f& u) const;
  float pdf(const Vec3f& point, const Vec3f& direction) const;
  /// Distance at which the ray enters; 0 without a hit.
  float hit(const Ray& ray) const;

  /// Approximately the projected area over squared distance; exactly 0 inside and below the point's
  /// horizon.
  float importance(const LightSampleContext& point) const;
  float importance_along(const Ray& ray, float begin, float end) const;
  LightBounds bounds(float luminance) const;
  void export_to(exchange::Light& light) const;

  const Vec3f& center() const { return center_; }
  float radius() const { return radius_; }
  /// Area of the sphere's projection along any direction.
  float cross_section() const { return kPif * radius_ * radius_; }

 private:
  /// 1 - cos of the half angle that it subtends, without cancellation; 0 inside.
  float cone(const Vec3f& to) const;

  Vec3f center_;
  float radius_;
};

}  // namespace vug::render
