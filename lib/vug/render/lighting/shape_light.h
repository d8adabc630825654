// SPDX-License-Identifier: Apache-2.0
// A light made of a shape, a radiance and an angular profile: the base of rectangle, disk, sphere,
// spot and measured lights.
#pragma once

#include <vug/exchange/light.h>
#include <vug/render/light.h>
#include <vug/render/lighting/light_output.h>

#include <type_traits>
#include <utility>

namespace vug::render {

/// Emits the same radiance in all directions. A profile returns the fraction (0 to 1) of the
/// radiance that leaves in a direction. `upper_bound` is the largest fraction that a point in that
/// direction may see, given the sine of the angle that the shape's bounding sphere subtends (0: the
/// point is not lit at all). `tighten` narrows the bounds.
struct UniformProfile {
  float operator()(const Vec3f&) const { return 1; }
  float upper_bound(const Vec3f&, float) const { return 1; }
  void tighten(LightBounds&) const {}
};

/// Shape has sample, pdf, hit, importance, importance_along, bounds, center, radius and export_to,
/// which describes the shape to exchange::Light; a profile may have export_to, too.
template <class Shape, class Profile = UniformProfile>
class ShapeLight : public Light {
 public:
  ShapeLight(Shape shape, const LightOutputParams& p, const Rgb& radiance, Profile profile = {})
      : Light(linking_of(p)),
        shape_(std::move(shape)),
        profile_(std::move(profile)),
        radiance_(radiance),
        power_(luminance(radiance)),
        visible_(p.visible) {}

  LightSample sample(const LightSampleContext& point, const Vec2f& u) const override {
    if (!(profile_bound(point.position) > 0)) return {};
    LightSample s = shape_.sample(point.position, u);
    s.radiance = radiance_ * profile_(-s.direction);
    return s;
  }
  float pdf(const LightSampleContext& point, const Vec3f& direction) const override {
    return profile_bound(point.position) > 0 ? shape_.pdf(point.position, direction) : 0;
  }
  float importance(const LightSampleContext& point) const override {
    return power_ * profile_bound(point.position) * shape_.importance(point);
  }
  float importance_along(const Ray& ray, float begin, float end) const override {
    return power_ * shape_.importance_along(ray, begin, end);
  }
  LightBounds bounds() const override {
    LightBounds out = shape_.bounds(power_);
    profile_.tighten(out);
    return out;
  }
  Vec3f center() const override { return shape_.center(); }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    const float t = shape_.hit(ray);
    if (!(t > 0 && t < max_distance)) return false;
    hit = {t, radiance_ * profile_(-ray.direction)};
    return true;
  }
  bool camera_visible() const override { return visible_; }
  bool as_data(exchange::Light& light) const override {
    light.radiance = Vec3d(radiance_);
    light.visible = visible_;
    shape_.export_to(light);
    if constexpr (requires { profile_.export_to(light); }) profile_.export_to(light);
    return true;
  }

 private:
  float profile_bound(const Vec3f& point) const {
    if constexpr (std::is_same_v<Profile, UniformProfile>) return 1;
    const Vec3f away = point - shape_.center();
    const float distance = length(away);
    return distance > 0 ? profile_.upper_bound(away * (1 / distance),
                                               std::min(1.0f, shape_.radius() / distance))
                        : 1;
  }

  Shape shape_;
  Profile profile_;
  Rgb radiance_;
  float power_;
  bool visible_;
};

}  // namespace vug::render
