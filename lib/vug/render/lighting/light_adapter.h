// SPDX-License-Identifier: Apache-2.0
// Adapter that forwards to another light every function that a derived class does not override.
#pragma once

#include <vug/render/light.h>

#include <utility>

namespace vug::render {

class LightAdapter : public Light {
 public:
  LightAdapter(LightPtr light, LightLinking linking)
      : Light(std::move(linking)), light_(std::move(light)) {}

  LightSample sample(const LightSampleContext& point, const Vec2f& u) const override {
    return light_->sample(point, u);
  }
  float pdf(const LightSampleContext& point, const Vec3f& direction) const override {
    return light_->pdf(point, direction);
  }
  float importance(const LightSampleContext& point) const override {
    return light_->importance(point);
  }
  float importance_along(const Ray& ray, float begin, float end) const override {
    return light_->importance_along(ray, begin, end);
  }
  LightBounds bounds() const override { return light_->bounds(); }
  Vec3f center() const override { return light_->center(); }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    return light_->intersect(ray, max_distance, hit);
  }
  bool camera_visible() const override { return light_->camera_visible(); }
  bool is_infinite() const override { return light_->is_infinite(); }
  bool is_portal() const override { return light_->is_portal(); }
  float mean_luminance() const override { return light_->mean_luminance(); }
  Rgb eval_environment(const Vec3f& direction) const override {
    return light_->eval_environment(direction);
  }
  bool sampled_with_portals() const override { return light_->sampled_with_portals(); }
  bool as_data(exchange::Light& light) const override { return light_->as_data(light); }

 protected:
  const Light& inner() const { return *light_; }

 private:
  LightPtr light_;
};

}  // namespace vug::render
