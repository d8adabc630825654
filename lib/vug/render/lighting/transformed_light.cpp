// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/exchange/light.h>
#include <vug/render/geometry/instance_transform.h>
#include <vug/render/lighting/light_adapter.h>
#include <vug/render/lighting/transformed_light.h>

namespace vug::render {
namespace {

/// Evaluates the light in its own space. Angles, solid angles and importance (power over squared
/// distance) are the same there; only lengths differ.
class TransformedLight final : public LightAdapter {
 public:
  TransformedLight(LightPtr light, const Transform& place, LightLinking linking)
      : LightAdapter(std::move(light), std::move(linking)),
        scale_(static_cast<float>(place.max_stretch())),
        place_(place),
        to_(place),
        back_(place.inverse()) {}

  LightSample sample(const LightSampleContext& point, const Vec2f& u) const override {
    LightSample s = inner().sample(own(point), u);
    s.direction = out(s.direction);
    s.distance *= scale_;
    return s;
  }
  float pdf(const LightSampleContext& point, const Vec3f& direction) const override {
    return inner().pdf(own(point), in(direction));
  }
  float importance(const LightSampleContext& point) const override {
    return inner().importance(own(point));
  }
  float importance_along(const Ray& ray, float begin, float end) const override {
    return inner().importance_along(own(ray), begin / scale_, end / scale_);
  }
  LightBounds bounds() const override {
    LightBounds b = inner().bounds();
    const Box3d box = place_.box(Box3d(Vec3d(b.box.min), Vec3d(b.box.max)));
    b.box = Box3f(Vec3f(box.min), Vec3f(box.max));
    b.axis = out(b.axis);
    b.strength *= scale_ * scale_;
    return b;
  }
  Vec3f center() const override { return to_.point(inner().center()); }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    if (!inner().intersect(own(ray), max_distance / scale_, hit)) return false;
    hit.distance *= scale_;
    return true;
  }
  bool as_data(exchange::Light& light) const override {
    if (!inner().as_data(light)) return false;
    const Transform placed = place_ * light.place;
    const auto axis = [&](int i) { return placed.column(i).normalized(); };
    light.place = Transform(axis(0), axis(1), axis(2), placed.origin());
    for (double* length : {&light.radius, &light.width, &light.height})
      *length *= static_cast<double>(scale_);
    return true;
  }

 private:
  /// Unit vectors stay unit except for rounding, which `normalized` removes.
  Vec3f in(const Vec3f& v) const { return normalized(back_.vector(v)); }
  Vec3f out(const Vec3f& v) const { return normalized(to_.vector(v)); }
  LightSampleContext own(LightSampleContext point) const {
    if (point.on_surface()) point.normal = in(point.normal);
    point.position = back_.point(point.position);
    return point;
  }
  Ray own(Ray ray) const {
    ray.origin = back_.point(ray.origin);
    ray.direction = in(ray.direction);
    return ray;
  }

  float scale_;
  Transform place_;
  Affine to_, back_;
};

}  // namespace

LightPtr transformed_light(LightPtr light, const Transform& place, LightLinking linking) {
  if (place.max_stretch() > 1.0001 * place.min_stretch())
    throw Error(ErrorCode::bad_input, "a light cannot be scaled non-uniformly", {},
                "place its scene with the same scale for all axes, or without the light");
  return std::make_shared<const TransformedLight>(std::move(light), place, std::move(linking));
}

}  // namespace vug::render
