// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/light.h>
#include <vug/render/lighting/sphere_shape.h>
#include <vug/render/sampling.h>

namespace vug::render {

float SphereShape::cone(const Vec3f& to) const {
  const float squared_sine = radius_ * radius_ / dot(to, to);
  return squared_sine < 1 ? one_minus_cosine(squared_sine) : 0;
}

LightSample SphereShape::sample(const Vec3f& point, const Vec2f& u) const {
  LightSample s;
  const Vec3f to = center_ - point;
  const float part = cone(to);
  if (!(part > 0)) return s;
  s.direction = Frame(normalized(to)).to_world(direction_off_axis(u.x * part, u.y));
  s.pdf = 1 / (2 * kPif * part);
  // At the cone's rim rounding may miss the sphere; the nearest point is then used.
  const float along = dot(to, s.direction);
  const float rest = radius_ * radius_ - (dot(to, to) - along * along);
  s.distance = along - std::sqrt(std::max(0.0f, rest));
  return s;
}

float SphereShape::pdf(const Vec3f& point, const Vec3f& direction) const {
  return hit({point, direction}) > 0 ? 1 / (2 * kPif * cone(center_ - point)) : 0;
}

float SphereShape::hit(const Ray& ray) const {
  const Vec3f to = center_ - ray.origin;
  const float along = dot(to, ray.direction);
  const Vec3f off = to - ray.direction * along;  // more accurate than |to|^2 - along^2
  const float rest = radius_ * radius_ - dot(off, off);
  if (!(along > 0 && rest >= 0) || dot(to, to) <= radius_ * radius_) return 0;
  return std::max(0.0f, along - std::sqrt(rest));
}

float SphereShape::importance(const LightSampleContext& point) const {
  const Vec3f to = center_ - point.position;
  const float squared = dot(to, to);
  if (!(squared > radius_ * radius_)) return 0;
  float cosine = 1;
  if (point.on_surface()) {
    const float height = dot(point.normal, to) + radius_;
    if (!(height > 0)) return 0;
    cosine = std::min(1.0f, height / std::sqrt(squared));
  }
  return cosine * cross_section() / squared;
}

float SphereShape::importance_along(const Ray& ray, float begin, float end) const {
  const float t = std::clamp(dot(center_ - ray.origin, ray.direction), begin, end);
  return cross_section() / std::max(length(center_ - ray.at(t)), radius_);
}

LightBounds SphereShape::bounds(float luminance) const {
  LightBounds out;
  out.box = {center_ - Vec3f(radius_), center_ + Vec3f(radius_)};
  out.strength = luminance * cross_section();
  return out;
}

void SphereShape::export_to(exchange::Light& light) const {
  light.shape = exchange::Light::Shape::sphere;
  light.place = Transform::translation(Vec3d(center_));
  light.radius = static_cast<double>(radius_);
}

}  // namespace vug::render
