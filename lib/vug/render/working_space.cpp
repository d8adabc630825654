#include <vug/render/kinds.h>
#include <vug/render/lighting/light_adapter.h>
#include <vug/render/working_space.h>

#include <map>

namespace vug::render {
namespace {

class SpacedLight final : public LightOfLight {
 public:
  SpacedLight(const LightPtr& light, const image::ColourMatrix& way)
      : LightOfLight(light, light->notes()), way_(way) {}

  LightSample sample(const LitPoint& point, const Vec2f& u) const override {
    LightSample s = inner().sample(point, u);
    s.radiance = way_(s.radiance);
    return s;
  }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    if (!inner().intersect(ray, max_distance, hit)) return false;
    hit.radiance = way_(hit.radiance);
    return true;
  }
  Rgb escape_radiance(const Vec3f& direction) const override {
    return way_(inner().escape_radiance(direction));
  }

 private:
  image::ColourMatrix way_;
};

class SpacedMedium final : public Medium {
 public:
  SpacedMedium(MediumPtr medium, const image::ColourMatrix& way)
      : medium_(std::move(medium)), way_(way) {}

  MediumPtr fitted(const Box3f& scene) const override {
    return in_space(medium_->fitted(scene), way_);
  }
  MediumPtr filled(std::shared_ptr<const volume::Density> density) const override {
    return in_space(medium_->filled(std::move(density)), way_);
  }
  bool hollow() const override { return medium_->hollow(); }
  Segment clip(const Ray& ray, float end) const override { return medium_->clip(ray, end); }
  float transmittance(const Ray& ray, const Segment& segment,
                      TrackingNumbers& numbers) const override {
    return medium_->transmittance(ray, segment, numbers);
  }
  DistanceSample cross(const Ray& ray, const Segment& segment, float u, std::span<Mark> marks,
                       TrackingNumbers& numbers) const override {
    return medium_->cross(ray, segment, u, marks, numbers);
  }
  float extinction(const Vec3f& point) const override { return medium_->extinction(point); }
  void expect(const Vec3f& point) const override { medium_->expect(point); }
  Rgb albedo(const Vec3f& point) const override { return way_(medium_->albedo(point)); }
  float usual_extinction() const override { return medium_->usual_extinction(); }
  Rgb glow(const Vec3f& point) const override { return way_(medium_->glow(point)); }
  bool burns() const override { return medium_->burns(); }
  Rgb flames(const Ray& ray, const Segment& segment, TrackingNumbers& numbers) const override {
    return way_(medium_->flames(ray, segment, numbers));
  }
  float phase(float cosine) const override { return medium_->phase(cosine); }
  Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const override {
    return medium_->sample_phase(travel, u);
  }

 private:
  MediumPtr medium_;
  image::ColourMatrix way_;
};

}  // namespace

LightPtr in_space(const LightPtr& light, const image::ColourMatrix& way) {
  return light && !way.plain() ? std::make_shared<const SpacedLight>(light, way) : light;
}

MediumPtr in_space(const MediumPtr& medium, const image::ColourMatrix& way) {
  return medium && !way.plain() ? std::make_shared<const SpacedMedium>(medium, way) : medium;
}

Scene in_space(Scene scene, image::WorkingSpace space) {
  const image::ColourMatrix way(image::WorkingSpace::rec709, space);
  if (way.plain()) return scene;
  for (LightPtr& light : scene.lights) light = in_space(light, way);
  scene.medium = in_space(scene.medium, way);
  std::map<MaterialPtr, MaterialPtr> made;
  for (Object& object : scene.objects) {
    // Without a material an object is grey times its vertex colours.
    MaterialPtr& material = made[object.material];
    if (!material)
      material = (object.material ? object.material : make_material("lambert"))->in_space(way);
    object.material = material;
    object.emission = way(object.emission);
  }
  return scene;
}

}  // namespace vug::render
