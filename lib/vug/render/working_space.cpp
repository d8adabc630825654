// SPDX-License-Identifier: Apache-2.0
#include <vug/render/kinds.h>
#include <vug/render/lighting/light_adapter.h>
#include <vug/render/working_space.h>

#include <map>

namespace vug::render {
namespace {

class SpacedLight final : public LightAdapter {
 public:
  SpacedLight(const LightPtr& light, const image::ColourMatrix& from_rec709)
      : LightAdapter(light, light->linking()), from_rec709_(from_rec709) {}

  LightSample sample(const LightSampleContext& point, const Vec2f& u) const override {
    LightSample s = inner().sample(point, u);
    s.radiance = from_rec709_(s.radiance);
    return s;
  }
  bool intersect(const Ray& ray, float max_distance, LightHit& hit) const override {
    if (!inner().intersect(ray, max_distance, hit)) return false;
    hit.radiance = from_rec709_(hit.radiance);
    return true;
  }
  Rgb eval_environment(const Vec3f& direction) const override {
    return from_rec709_(inner().eval_environment(direction));
  }

 private:
  image::ColourMatrix from_rec709_;
};

class SpacedMedium final : public Medium {
 public:
  SpacedMedium(MediumPtr medium, const image::ColourMatrix& from_rec709)
      : medium_(std::move(medium)), from_rec709_(from_rec709) {}

  MediumPtr with_bounds(const Box3f& scene) const override {
    return in_space(medium_->with_bounds(scene), from_rec709_);
  }
  MediumPtr with_density(std::shared_ptr<const volume::Density> density) const override {
    return in_space(medium_->with_density(std::move(density)), from_rec709_);
  }
  bool needs_density() const override { return medium_->needs_density(); }
  Segment clip(const Ray& ray, float end) const override { return medium_->clip(ray, end); }
  float transmittance(const Ray& ray, const Segment& segment, TrackingRng& numbers) const override {
    return medium_->transmittance(ray, segment, numbers);
  }
  DistanceSample sample_distance(const Ray& ray, const Segment& segment, float u,
                                 std::span<ScatterPoint> scatter_points,
                                 TrackingRng& numbers) const override {
    return medium_->sample_distance(ray, segment, u, scatter_points, numbers);
  }
  float extinction(const Vec3f& point) const override { return medium_->extinction(point); }
  void prefetch(const Vec3f& point) const override { medium_->prefetch(point); }
  Rgb albedo(const Vec3f& point) const override { return from_rec709_(medium_->albedo(point)); }
  float typical_extinction() const override { return medium_->typical_extinction(); }
  Rgb emission(const Vec3f& point) const override { return from_rec709_(medium_->emission(point)); }
  bool is_emissive() const override { return medium_->is_emissive(); }
  Rgb sample_emission(const Ray& ray, const Segment& segment, TrackingRng& numbers) const override {
    return from_rec709_(medium_->sample_emission(ray, segment, numbers));
  }
  float phase(float cosine) const override { return medium_->phase(cosine); }
  Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const override {
    return medium_->sample_phase(travel, u);
  }

 private:
  MediumPtr medium_;
  image::ColourMatrix from_rec709_;
};

}  // namespace

LightPtr in_space(const LightPtr& light, const image::ColourMatrix& from_rec709) {
  return light && !from_rec709.is_identity()
             ? std::make_shared<const SpacedLight>(light, from_rec709)
             : light;
}

MediumPtr in_space(const MediumPtr& medium, const image::ColourMatrix& from_rec709) {
  return medium && !from_rec709.is_identity()
             ? std::make_shared<const SpacedMedium>(medium, from_rec709)
             : medium;
}

Scene in_space(Scene scene, image::WorkingSpace space) {
  const image::ColourMatrix from_rec709(image::WorkingSpace::rec709, space);
  if (from_rec709.is_identity()) return scene;
  for (LightPtr& light : scene.lights) light = in_space(light, from_rec709);
  scene.medium = in_space(scene.medium, from_rec709);
  std::map<MaterialPtr, MaterialPtr> made;
  for (Object& object : scene.objects) {
    // An object without a material is grey, times its vertex colours.
    MaterialPtr& material = made[object.material];
    if (!material)
      material =
          (object.material ? object.material : make_material("lambert"))->in_space(from_rec709);
    object.material = material;
    object.emission = from_rec709(object.emission);
  }
  return scene;
}

}  // namespace vug::render
